import type { Quat } from '../../math/quat.ts';
import { length, negate, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { apparentPosition, inverseApparentPosition } from '../../physics/optics/apparentPosition.ts';
import { pastLightCone } from '../../physics/worldLines/lightCone.ts';
import { simultaneitySlice } from '../../physics/worldLines/simultaneity.ts';
import { velocityAt } from '../../physics/worldLines/worldLine.ts';
import { poseAt } from '../../scene/motion/motion.ts';
import { maxOfFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { type LightingContext, type MovingLight, rayBack, restFrameOf } from '../lights/lightingContext.ts';
import { sampleLocalLight } from '../lights/localLightSamples.ts';
import type { Sun } from '../lights/sky.ts';
import { type Brdf, evaluateBrdf } from '../materials/brdf.ts';
import { coneDirection } from '../sampling/directions.ts';
import { type RestFrame, WORLD_FRAME } from '../spectral/restFrame.ts';
import { NO_LIGHT, plus, type SampledRadiance } from '../spectral/sampledRadiance.ts';
import type { SourceSpectrum } from '../spectral/sourceSpectrum.ts';
import { IRRADIANCE_POWER, type LightReceiver, receivedLight } from '../spectral/spectralContext.ts';
import type { SurfaceOrigin } from './rayOrigin.ts';
import { transmittance } from './transmittance.ts';

/** What a surface, at rest `here`, reflects of suns and lamps: radiance, in its rest frame. */
export function directLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  look: Brdf,
  here: LightReceiver,
): SampledRadiance {
  let sum = NO_LIGHT;
  for (const sun of lighting.suns) sum = plus(sum, reflectedLight(lighting, at, look, here, sampleSun(lighting, sun)));
  for (const lamp of lighting.localLights) {
    const light = sampleMovingLight(lighting, lamp, at);
    if (light) sum = plus(sum, reflectedLight(lighting, at, look, here, light));
  }
  return sum;
}

/** Light that arrives from one direction, or its sample from a small cone. */
interface IncidentLight {
  /** Surface → where it was sent out [m, world]; of suns only the direction. */
  readonly dx: Vec3;
  /** The same of what tells whether it arrives. */
  readonly rayDirection: Vec3;
  /** Part of dx that is free of the light itself. */
  readonly end: number;
  /** What sends it out, at rest in that frame: `weight` times its light is the irradiance there of a surface that faces it. */
  readonly sourceSpectrum: SourceSpectrum;
  readonly sourceFrame: RestFrame;
  readonly weight: number;
}

function reflectedLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  look: Brdf,
  here: LightReceiver,
  arriving: IncidentLight,
): SampledRadiance {
  const { dx, rayDirection, end, sourceSpectrum: shine, sourceFrame: source, weight } = arriving;
  const n = normalize(dx);
  const filter = evaluateBrdf(look, here.frame.fromWorld(n));
  if (!filter || maxOfFilter(filter) === 0) return NO_LIGHT;
  const beam = { ray: rayBack(lighting, at, rayDirection), begin: at.clearance / length(rayDirection), from: at.hit };
  const share = transmittance(lighting.scene, beam, end);
  if (share === 0) return NO_LIGHT;
  const irradiance = receivedLight(here, n, source, IRRADIANCE_POWER, ({ context: sight }) => sight.emitted(shine));
  return here.context.filtered(irradiance, scaleFilter(filter, share * weight));
}

/** Infinitely far away and always there: E′ = D² E. It shines as from its middle; what hides it hides points of its disc. */
function sampleSun({ random }: LightingContext, { direction, radius, sourceSpectrum: shine }: Sun): IncidentLight {
  const dx = normalize(negate(direction));
  const past = radius > 0 ? coneDirection(dx, 1 - Math.cos(radius), random) : dx;
  return {
    dx,
    rayDirection: past,
    end: Number.POSITIVE_INFINITY,
    sourceSpectrum: shine,
    sourceFrame: WORLD_FRAME,
    weight: 1,
  };
}

/**
 * A lamp where it was when it sent out what arrives. In its own frame it rests at a distance d′ and is seen within a solid angle Ω′ (of a
 * sphere 2π(1 − √(1 − (radius/d′)²))); so E = D² L Ω′ = D⁴ L Ω, and of a point E = D² I/d′² = D⁴ I/r² where surface and world are one.
 * Its velocity and its axes are taken as constant while its light crosses it. undefined: none of its light is here yet, or any more.
 */
function sampleMovingLight(lighting: LightingContext, lamp: MovingLight, at: SurfaceOrigin): IncidentLight | undefined {
  const { light, sourceSpectrum: shine } = lamp;
  const seen = lightAtEmission(lighting, lamp, at);
  if (!seen) return undefined;
  const center = apparentPosition(seen.offset, seen.frame.u);
  const sample = sampleLocalLight(light, center, seen.orientation, lighting.random);
  if (!sample) return undefined;
  const dx = inverseApparentPosition(sample.toward, seen.frame.u);
  const time = at.t + rayBack(lighting, at, dx).dt / lighting.scene.c;
  if (time < light.lifetime.birth || time > light.lifetime.death) return undefined;
  return { dx, rayDirection: dx, end: 1 - 1e-9, sourceSpectrum: shine, sourceFrame: seen.frame, weight: sample.weight };
}

interface LightAtEmission {
  /** From the surface to its centre [m, world]. */
  readonly offset: Vec3;
  /** Its frame then, and how its own axes stand there. */
  readonly frame: RestFrame;
  readonly orientation: Quat;
}

function lightAtEmission(
  lighting: LightingContext,
  { line, light }: MovingLight,
  { t, x }: SurfaceOrigin,
): LightAtEmission | undefined {
  const { propagation, scene } = lighting;
  const observer = { t, position: x };
  const event = (): { offset: Vec3; time: number } | undefined => {
    if (propagation.kind === 'slice') {
      const { offset, ahead } = simultaneitySlice(line, observer, propagation.u, scene.c);
      return { offset, time: t + ahead / scene.c };
    }
    const found = pastLightCone(line, observer, scene.c);
    return found && { offset: found.offset, time: t - found.delay / scene.c };
  };
  const found = event();
  if (!found) return undefined;
  const velocity = scale(velocityAt(line, found.time, scene.c), 1 / scene.c);
  const { orientation } = poseAt(light.motion, found.time, scene.c);
  return { offset: found.offset, frame: restFrameOf(lighting, velocity), orientation };
}
