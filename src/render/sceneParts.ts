import { sceneNightSky } from '../scene/lights/sceneLights.ts';
import { isLayered } from '../scene/materials/layered.ts';
import type { Scene } from '../scene/types.ts';
import type { LayeredScene } from './layers/layeredScene.ts';
import type { StarPoints } from './shading/starPoints.ts';

/** Code that few scenes need: loaded by the first that does. */
export interface SceneParts {
  /** For materials with layers. */
  readonly Layered?: typeof LayeredScene;
  /** For night skies. */
  readonly StarPoints?: typeof StarPoints;
}

/** Those that the scenes need, and those that are there. */
export async function loadSceneParts(scenes: readonly Scene[], loaded: SceneParts): Promise<SceneParts> {
  const layered = scenes.some(({ materials }) => materials.some(isLayered));
  const starry = scenes.some((scene) => sceneNightSky(scene) !== undefined);
  return {
    ...loaded,
    ...(layered && { Layered: (await import('./layers/layeredScene.ts')).LayeredScene }),
    ...(starry && { StarPoints: (await import('./shading/starPoints.ts')).StarPoints }),
  };
}
