import { isDomeLight } from '../scene/lights/lightKinds.ts';
import { sceneNightSky } from '../scene/lights/sceneLights.ts';
import { isLayered } from '../scene/materials/layered.ts';
import type { Scene } from '../scene/types.ts';
import type { LayeredScene } from './layers/layeredScene.ts';
import type { DomeTexture } from './lights/sky/domeTexture.ts';
import type { StarPoints } from './shading/starPoints.ts';

/** Code that few scenes need: loaded by the first that does. */
export interface SceneParts {
  /** For materials with layers. */
  readonly Layered?: typeof LayeredScene;
  /** For domes with a picture, of which that of a night sky is one. */
  readonly DomeTexture?: typeof DomeTexture;
  /** For night skies. */
  readonly StarPoints?: typeof StarPoints;
}

/** Those that the scenes need, and those that are there. */
export async function loadSceneParts(scenes: readonly Scene[], loaded: SceneParts): Promise<SceneParts> {
  const layered = scenes.some(({ materials }) => materials.some(isLayered));
  const starry = scenes.some((scene) => sceneNightSky(scene) !== undefined);
  const pictured = starry || scenes.some(({ lights }) => lights.some((light) => isDomeLight(light) && light.texture));
  return {
    ...loaded,
    ...(layered && { Layered: (await import('./layers/layeredScene.ts')).LayeredScene }),
    ...(pictured && { DomeTexture: (await import('./lights/sky/domeTexture.ts')).DomeTexture }),
    ...(starry && { StarPoints: (await import('./shading/starPoints.ts')).StarPoints }),
  };
}
