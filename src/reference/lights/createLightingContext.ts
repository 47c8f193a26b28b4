import type { Random } from '../../math/random.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { lightSurfaceOf } from '../../physics/worldLines/hypersurface.ts';
import { isDistantLight, isLocalLight } from '../../scene/lights/lightKinds.ts';
import { directLights } from '../../scene/lights/sceneLights.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { hypersurfaceChoice } from '../../scene/views/views.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import type { LightingContext, LightPropagation } from './lightingContext.ts';
import type { LightOptions } from './lightOptions.ts';
import { tracedLight } from './lightTracers.ts';
import { skyOf } from './sky.ts';

type SceneLights = Pick<LightingContext, 'sky' | 'directLights'>;

/** Per scene, since its lights are the same for all rays. */
const sceneLightsCache = new WeakMap<TracedScene, SceneLights>();

function sceneLights(traced: TracedScene): SceneLights {
  const cached = sceneLightsCache.get(traced);
  if (cached) return cached;
  const { scene } = traced;
  const lights = directLights(scene);
  const direct = [...lights.filter(isDistantLight), ...lights.filter(isLocalLight)];
  const sources = direct.map((light) => tracedLight(light, scene));
  const lightsOfScene = { sky: skyOf(scene, sources), directLights: sources };
  sceneLightsCache.set(traced, lightsOfScene);
  return lightsOfScene;
}

/** `u`: the observer's γβ. */
export function createLightingContext(
  scene: TracedScene,
  settings: RenderSettings,
  options: LightOptions,
  u: Vec3,
  random: Random,
): LightingContext {
  const propagation: LightPropagation = { hypersurface: lightSurfaceOf(hypersurfaceChoice(settings)), u };
  return { scene, settings, options, random, propagation, ...sceneLights(scene) };
}
