import { dot, length, type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma, inverseBoost, properVelocity } from '../../physics/lorentz/boost.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { directLights, distantLightRadius } from '../../scene/lights/sceneLights.ts';
import { originWorldLine } from '../../scene/motion/motion.ts';
import type { LocalLight } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import type { TracedScene } from '../intersection/tracedScene.ts';
import type { Random } from '../sampling/directions.ts';
import { type RestFrame, restFrame } from '../spectral/restFrame.ts';
import { type SourceSpectrum, sourceSpectrumOf } from '../spectral/sourceSpectrum.ts';
import type { LightOptions } from './lightOptions.ts';
import { type Sky, type Sun, skyOf } from './sky.ts';

/** A lamp, the world line of its centre, and what it shines with. */
export interface MovingLight {
  readonly light: LocalLight;
  readonly line: WorldLine;
  readonly sourceSpectrum: SourceSpectrum;
}

/** Everything that one sample of a picture asks for while it follows its light back. */
export interface LightingContext {
  readonly scene: TracedScene;
  readonly settings: RenderSettings;
  readonly options: LightOptions;
  readonly random: Random;
  readonly sky: Sky;
  readonly suns: readonly Sun[];
  readonly localLights: readonly MovingLight[];
  /** Which events light each other. */
  readonly propagation: LightPropagation;
}

/** Light that takes its time; or, where the picture is of one moment (a slice of u's own time; the world's for u = 0), none. */
export type LightPropagation = { readonly kind: 'past' } | { readonly kind: 'slice'; readonly u: Vec3 };

/** What a scene shines with is the same for all rays. */
const known = new WeakMap<TracedScene, Pick<LightingContext, 'sky' | 'suns' | 'localLights'>>();

function sceneLights(traced: TracedScene): Pick<LightingContext, 'sky' | 'suns' | 'localLights'> {
  const found = known.get(traced);
  if (found) return found;
  const lights = directLights(traced.scene);
  const suns = lights
    .filter((light) => light.kind === 'distant')
    .map((light) => ({
      direction: light.direction,
      radius: distantLightRadius(light),
      sourceSpectrum: sourceSpectrumOf(light.color, light.spectrum),
    }));
  const localLights = lights
    .filter((light) => light.kind !== 'distant')
    .map((light) => ({
      light,
      line: originWorldLine(light.motion),
      sourceSpectrum: sourceSpectrumOf(light.color, light.spectrum),
    }));
  const made = { sky: skyOf(traced.scene, suns), suns, localLights };
  known.set(traced, made);
  return made;
}

/** `u`: the observer's γβ. */
export function createLightingContext(
  scene: TracedScene,
  settings: RenderSettings,
  options: LightOptions,
  u: Vec3,
  random: Random,
): LightingContext {
  const when: LightPropagation =
    settings.view === 'light-cone' && settings.lightDelay
      ? { kind: 'past' }
      : { kind: 'slice', u: settings.view === 'simultaneity' ? u : ZERO };
  return { scene, settings, options, random, propagation: when, ...sceneLights(scene) };
}

/** The rest frame of a velocity [c]; in the views that show no light everything is as at rest. */
export const restFrameOf = ({ settings }: LightingContext, velocity: Vec3): RestFrame =>
  restFrame(settings.view === 'light-cone' ? properVelocity(velocity) : ZERO);

/** An event, and how much of a ray that leaves it does not count [m]: what rounding may put between it and its own surface. */
export interface RayOrigin {
  readonly t: number;
  readonly x: Vec3;
  readonly clearance: number;
}

/** The ray from an event to where light from the direction dx [m, world] came from. */
export function rayBack({ propagation }: LightingContext, { t, x }: RayOrigin, dx: Vec3): SpacetimeRay {
  if (propagation.kind === 'past') return { t, x, dt: -length(dx), dx };
  return { t, x, dt: dot(propagation.u, dx) / gamma(propagation.u), dx };
}

/** The same inside a body of refractive index n that moves with u, for a unit direction of its rest frame: light goes at c/n there. */
export function rayBackInside(
  lighting: LightingContext,
  { t, x, clearance }: RayOrigin,
  direction: Vec3,
  frame: RestFrame,
  n: number,
): SpacetimeRay {
  if (lighting.propagation.kind !== 'past') return rayBack(lighting, { t, x, clearance }, frame.toWorld(direction));
  const [dt, ...dx] = inverseBoost([-n, ...direction], frame.u);
  return { t, x, dt, dx };
}
