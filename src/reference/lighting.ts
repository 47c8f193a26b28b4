import { dot, length, type Vec3, ZERO } from '../math/vec3.ts';
import { gamma, inverseBoost, properVelocity } from '../physics/boost.ts';
import type { WorldLine } from '../physics/worldLine.ts';
import { directLights, sunRadius } from '../scene/daylight.ts';
import { originLine } from '../scene/motion.ts';
import type { Lamp } from '../scene/types.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { Random } from './directions.ts';
import type { LightOptions } from './lightOptions.ts';
import { type RestFrame, restFrame } from './restFrame.ts';
import { type Shine, shineOf } from './shine.ts';
import { type Sky, type Sun, skyOf } from './sky.ts';
import type { TracedScene } from './trace.ts';
import type { SpacetimeRay } from './types.ts';

/** A lamp, the world line of its centre, and what it shines with. */
export interface MovingLamp {
  readonly light: Lamp;
  readonly line: WorldLine;
  readonly shine: Shine;
}

/** Everything that one sample of a picture asks for while it follows its light back. */
export interface Lighting {
  readonly scene: TracedScene;
  readonly settings: RenderSettings;
  readonly options: LightOptions;
  readonly random: Random;
  readonly sky: Sky;
  readonly suns: readonly Sun[];
  readonly lamps: readonly MovingLamp[];
  /** Which events light each other. */
  readonly when: When;
}

/** Light that takes its time; or, where the picture is of one moment (a slice of u's own time; the world's for u = 0), none. */
export type When = { readonly kind: 'past' } | { readonly kind: 'slice'; readonly u: Vec3 };

/** What a scene shines with is the same for all rays. */
const known = new WeakMap<TracedScene, Pick<Lighting, 'sky' | 'suns' | 'lamps'>>();

function lightsOf(traced: TracedScene): Pick<Lighting, 'sky' | 'suns' | 'lamps'> {
  const found = known.get(traced);
  if (found) return found;
  const lights = directLights(traced.scene);
  const suns = lights
    .filter((light) => light.kind === 'distant')
    .map((light) => ({
      direction: light.direction,
      radius: sunRadius(light),
      shine: shineOf(light.color, light.spectrum),
    }));
  const lamps = lights
    .filter((light) => light.kind !== 'distant')
    .map((light) => ({ light, line: originLine(light.motion), shine: shineOf(light.color, light.spectrum) }));
  const made = { sky: skyOf(traced.scene, suns), suns, lamps };
  known.set(traced, made);
  return made;
}

/** `u`: the observer's γβ. */
export function lightingOf(
  scene: TracedScene,
  settings: RenderSettings,
  options: LightOptions,
  u: Vec3,
  random: Random,
): Lighting {
  const when: When =
    settings.view === 'light-cone' && settings.lightDelay
      ? { kind: 'past' }
      : { kind: 'slice', u: settings.view === 'simultaneity' ? u : ZERO };
  return { scene, settings, options, random, when, ...lightsOf(scene) };
}

/** The rest frame of a velocity [c]; in the views that show no light everything is as at rest. */
export const frameOf = ({ settings }: Lighting, velocity: Vec3): RestFrame =>
  restFrame(settings.view === 'light-cone' ? properVelocity(velocity) : ZERO);

/** An event, and how much of a ray that leaves it does not count [m]: what rounding may put between it and its own surface. */
export interface Start {
  readonly t: number;
  readonly x: Vec3;
  readonly clear: number;
}

/** The ray from an event to where light from the direction dx [m, world] came from. */
export function rayBack({ when }: Lighting, { t, x }: Start, dx: Vec3): SpacetimeRay {
  if (when.kind === 'past') return { t, x, dt: -length(dx), dx };
  return { t, x, dt: dot(when.u, dx) / gamma(when.u), dx };
}

/** The same inside a body of refractive index n that moves with u, for a unit direction of its rest frame: light goes at c/n there. */
export function rayBackInside(
  lighting: Lighting,
  { t, x, clear }: Start,
  direction: Vec3,
  frame: RestFrame,
  n: number,
): SpacetimeRay {
  if (lighting.when.kind !== 'past') return rayBack(lighting, { t, x, clear }, frame.out(direction));
  const [dt, ...dx] = inverseBoost([-n, ...direction], frame.u);
  return { t, x, dt, dx };
}
