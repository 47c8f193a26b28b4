import type { Quat } from '../math/quat.ts';
import { length, negate, normalize, scale, type Vec3 } from '../math/vec3.ts';
import { apparentPosition, inverseApparentPosition } from '../physics/apparent.ts';
import { pastLightCone } from '../physics/lightCone.ts';
import { simultaneitySlice } from '../physics/simultaneity.ts';
import { velocityAt } from '../physics/worldLine.ts';
import { poseAt } from '../scene/motion.ts';
import type { Departure } from './departure.ts';
import { coneDirection } from './directions.ts';
import { dimmed, largest } from './filters.ts';
import { sampleLamp } from './lampSamples.ts';
import { DARK, type Light, plus } from './light.ts';
import { frameOf, type Lighting, type MovingLamp, rayBack } from './lighting.ts';
import { transmitted } from './passage.ts';
import { type Look, reflectance } from './reflectance.ts';
import { type RestFrame, WORLD } from './restFrame.ts';
import type { Shine } from './shine.ts';
import { IRRADIANCE, type Receiver, received } from './sight.ts';
import type { Sun } from './sky.ts';

/** What a surface, at rest `here`, reflects of suns and lamps: radiance, in its rest frame. */
export function directLight(lighting: Lighting, at: Departure, look: Look, here: Receiver): Light {
  let sum = DARK;
  for (const sun of lighting.suns) sum = plus(sum, reflected(lighting, at, look, here, sunlight(lighting, sun)));
  for (const lamp of lighting.lamps) {
    const light = lamplight(lighting, lamp, at);
    if (light) sum = plus(sum, reflected(lighting, at, look, here, light));
  }
  return sum;
}

/** Light that arrives from one direction, or its sample from a small cone. */
interface Arriving {
  /** Surface → where it was sent out [m, world]; of suns only the direction. */
  readonly dx: Vec3;
  /** The same of what tells whether it arrives. */
  readonly past: Vec3;
  /** Part of dx that is free of the light itself. */
  readonly end: number;
  /** What sends it out, at rest in that frame: `weight` times its light is the irradiance there of a surface that faces it. */
  readonly shine: Shine;
  readonly source: RestFrame;
  readonly weight: number;
}

function reflected(lighting: Lighting, at: Departure, look: Look, here: Receiver, arriving: Arriving): Light {
  const { dx, past, end, shine, source, weight } = arriving;
  const n = normalize(dx);
  const filter = reflectance(look, here.frame.into(n));
  if (!filter || largest(filter) === 0) return DARK;
  const beam = { ray: rayBack(lighting, at, past), begin: at.clear / length(past), from: at.hit };
  const share = transmitted(lighting.scene, beam, end);
  if (share === 0) return DARK;
  const irradiance = received(here, n, source, IRRADIANCE, ({ sight }) => sight.shining(shine));
  return here.sight.filtered(irradiance, dimmed(filter, share * weight));
}

/** Infinitely far away and always there: E′ = D² E. It shines as from its middle; what hides it hides points of its disc. */
function sunlight({ random }: Lighting, { direction, radius, shine }: Sun): Arriving {
  const dx = normalize(negate(direction));
  const past = radius > 0 ? coneDirection(dx, 1 - Math.cos(radius), random) : dx;
  return { dx, past, end: Number.POSITIVE_INFINITY, shine, source: WORLD, weight: 1 };
}

/**
 * A lamp where it was when it sent out what arrives. In its own frame it rests at a distance d′ and is seen within a solid angle Ω′ (of a
 * sphere 2π(1 − √(1 − (radius/d′)²))); so E = D² L Ω′ = D⁴ L Ω, and of a point E = D² I/d′² = D⁴ I/r² where surface and world are one.
 * Its velocity and its axes are taken as constant while its light crosses it. undefined: none of its light is here yet, or any more.
 */
function lamplight(lighting: Lighting, lamp: MovingLamp, at: Departure): Arriving | undefined {
  const { light, shine } = lamp;
  const seen = lampSeen(lighting, lamp, at);
  if (!seen) return undefined;
  const centre = apparentPosition(seen.offset, seen.frame.u);
  const sample = sampleLamp(light, centre, seen.orientation, lighting.random);
  if (!sample) return undefined;
  const dx = inverseApparentPosition(sample.toward, seen.frame.u);
  const time = at.t + rayBack(lighting, at, dx).dt / lighting.scene.c;
  if (time < light.lifetime.birth || time > light.lifetime.death) return undefined;
  return { dx, past: dx, end: 1 - 1e-9, shine, source: seen.frame, weight: sample.weight };
}

interface SeenLamp {
  /** From the surface to its centre [m, world]. */
  readonly offset: Vec3;
  /** Its frame then, and how its own axes stand there. */
  readonly frame: RestFrame;
  readonly orientation: Quat;
}

function lampSeen(lighting: Lighting, { line, light }: MovingLamp, { t, x }: Departure): SeenLamp | undefined {
  const { when, scene } = lighting;
  const observer = { t, position: x };
  const event = (): { offset: Vec3; time: number } | undefined => {
    if (when.kind === 'slice') {
      const { offset, ahead } = simultaneitySlice(line, observer, when.u, scene.c);
      return { offset, time: t + ahead / scene.c };
    }
    const found = pastLightCone(line, observer, scene.c);
    return found && { offset: found.offset, time: t - found.delay / scene.c };
  };
  const found = event();
  if (!found) return undefined;
  const velocity = scale(velocityAt(line, found.time, scene.c), 1 / scene.c);
  const { orientation } = poseAt(light.motion, found.time, scene.c);
  return { offset: found.offset, frame: frameOf(lighting, velocity), orientation };
}
