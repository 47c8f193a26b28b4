import type { Quat } from '../math/quat.ts';
import { add, length, negate, normalize, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { apparentPosition, inverseApparentPosition } from '../physics/apparent.ts';
import { pastLightCone } from '../physics/lightCone.ts';
import { simultaneitySlice } from '../physics/simultaneity.ts';
import { velocityAt } from '../physics/worldLine.ts';
import { poseAt } from '../scene/motion.ts';
import type { DistantLight } from '../scene/types.ts';
import type { Departure } from './departure.ts';
import { sampleLamp } from './lampSamples.ts';
import { frameOf, type Lighting, type MovingLamp, rayBack } from './lighting.ts';
import { transmitted } from './passage.ts';
import { type Look, reflectance } from './reflectance.ts';
import { dopplerBetween, type RestFrame } from './restFrame.ts';
import { met } from './shift.ts';

/** What a surface at rest in `frame` reflects of suns and lamps: radiance, in its rest frame. */
export function directLight(lighting: Lighting, at: Departure, look: Look, frame: RestFrame): Vec3 {
  let sum = ZERO;
  for (const sun of lighting.suns) sum = add(sum, reflected(lighting, at, look, frame, sunlight(lighting, sun, frame)));
  for (const lamp of lighting.lamps) {
    const light = lamplight(lighting, lamp, at, frame);
    if (light) sum = add(sum, reflected(lighting, at, look, frame, light));
  }
  return sum;
}

/** Light that arrives from one direction, or its sample from a small cone. */
interface Arriving {
  /** Surface → where it was sent out [m, world]; of suns only the direction. */
  readonly dx: Vec3;
  /** Part of dx that is free of the light itself. */
  readonly end: number;
  /** On a surface that faces it, in the surface's rest frame. */
  readonly irradiance: Vec3;
}

function reflected(
  lighting: Lighting,
  at: Departure,
  look: Look,
  frame: RestFrame,
  { dx, end, irradiance }: Arriving,
): Vec3 {
  const L = frame.into(normalize(dx));
  const f = reflectance(look, L);
  if (f[0] + f[1] + f[2] === 0) return ZERO;
  const beam = { ray: rayBack(lighting, at, dx), begin: at.clear / length(dx), from: at.hit };
  const share = transmitted(lighting.scene, beam, end);
  return share === 0
    ? ZERO
    : [share * f[0] * irradiance[0], share * f[1] * irradiance[1], share * f[2] * irradiance[2]];
}

/** Infinitely far away and always there: E′ = D² E. */
function sunlight({ settings }: Lighting, { direction, color }: DistantLight, frame: RestFrame): Arriving {
  const dx = normalize(negate(direction));
  return { dx, end: Number.POSITIVE_INFINITY, irradiance: met(color, frame.doppler(dx), settings) };
}

/**
 * A lamp where it was when it sent out what arrives. In its own frame it rests at a distance d′ and is seen within a solid angle Ω′ (of a
 * sphere 2π(1 − √(1 − (radius/d′)²))); so E = D² L Ω′ = D⁴ L Ω, and of a point E = D² I/d′² = D⁴ I/r² where surface and world are one.
 * Its velocity and its axes are taken as constant while its light crosses it. undefined: none of its light is here yet, or any more.
 */
function lamplight(lighting: Lighting, lamp: MovingLamp, at: Departure, frame: RestFrame): Arriving | undefined {
  const { light } = lamp;
  const seen = lampSeen(lighting, lamp, at);
  if (!seen) return undefined;
  const centre = apparentPosition(seen.offset, seen.frame.u);
  const sample = sampleLamp(light, centre, seen.orientation, lighting.random);
  if (!sample) return undefined;
  const dx = inverseApparentPosition(sample.toward, seen.frame.u);
  const time = at.t + rayBack(lighting, at, dx).dt / lighting.scene.c;
  if (time < light.lifetime.birth || time > light.lifetime.death) return undefined;
  const D = dopplerBetween(normalize(dx), frame, seen.frame);
  return { dx, end: 1 - 1e-9, irradiance: scale(met(light.color, D, lighting.settings), sample.weight) };
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
