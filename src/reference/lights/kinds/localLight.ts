import { conjugate, type Quat, rotate } from '../../../math/quat.ts';
import type { Random } from '../../../math/random.ts';
import { length, negate, normalize, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { apparentPosition, inverseApparentPosition } from '../../../physics/optics/apparentPosition.ts';
import { velocityAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { shapingFactor } from '../../../scene/lights/shaping.ts';
import { isAlive } from '../../../scene/motion/lifetimes.ts';
import { originWorldLine, poseAt } from '../../../scene/motion/motion.ts';
import type { LocalLight } from '../../../scene/types.ts';
import type { RestFrame } from '../../spectral/restFrame.ts';
import { sourceSpectrumOf } from '../../spectral/sourceSpectrum.ts';
import { type IncidentLight, type LightingContext, type RayOrigin, rayBack, restFrameOf } from '../lightingContext.ts';
import type { LightTracer } from './lightTracer.ts';

/** A random point of a light relative to a surface, in the light's rest frame, on the world's axes. */
export interface LightSample {
  /** From the surface to the point [m]. */
  readonly toward: Vec3;
  /** Factor of the light's colour; its mean is the light's solid angle, or 1/d² for a point. */
  readonly weight: number;
}

/** `center`: from the surface to the light's centre [m]; `orientation`: of its axes. Returns undefined if the sample sends no light to the surface. */
export type SampleShape<L extends LocalLight> = (
  light: L,
  center: Vec3,
  orientation: Quat,
  random: Random,
) => LightSample | undefined;

/** A `SampleShape` from one on the light's own axes. `at`: the surface relative to the light's centre [m]. */
export const inOwnFrame =
  <L extends LocalLight>(sample: (at: Vec3, light: L, random: Random) => LightSample | undefined): SampleShape<L> =>
  (light, center, orientation, random) => {
    const at = rotate(conjugate(orientation), negate(center));
    const local = sample(at, light, random);
    return local && { ...local, toward: rotate(orientation, local.toward) };
  };

/** The sample of a point chosen uniformly on a face in the light's XY plane: dΩ = cos θ dA/d². */
export function areaSample(at: Vec3, spot: Vec3, area: number): LightSample {
  const toward = sub(spot, at);
  return { toward, weight: (area * -at[2]) / length(toward) ** 3 };
}

/** The tracer of a kind of local light, given the sampling of its shape. */
export const localLightTracer = <L extends LocalLight>(sampleShape: SampleShape<L>): LightTracer<L> => ({
  trace(light) {
    const moving = {
      light,
      line: originWorldLine(light.motion),
      sourceSpectrum: sourceSpectrumOf(light.color, light.spectrum),
    };
    return { sample: (lighting, at) => sampleMovingLight(lighting, moving, at, sampleShape) };
  },
});

interface MovingLight<L extends LocalLight> extends Pick<IncidentLight, 'sourceSpectrum'> {
  readonly light: L;
  /** World line of its centre. */
  readonly line: WorldLine;
}

/**
 * Samples a light where it was when it emitted what arrives. In its own frame it is at rest at a distance d′ and covers the solid angle Ω′ (of a
 * sphere 2π(1 − √(1 − (radius/d′)²))); so E = D² L Ω′ = D⁴ L Ω, and for a point E = D² I/d′² = D⁴ I/r² on a surface at rest in the world
 * (docs/physics.md §6.4). Velocity and axes are taken as constant while light crosses it. Returns undefined if none of its light arrives at this time.
 */
function sampleMovingLight<L extends LocalLight>(
  lighting: LightingContext,
  moving: MovingLight<L>,
  at: RayOrigin,
  sampleShape: SampleShape<L>,
): IncidentLight | undefined {
  const { light, sourceSpectrum } = moving;
  const emitter = lightAtEmission(lighting, moving, at);
  if (!emitter) return undefined;
  const center = apparentPosition(emitter.offset, emitter.frame.u);
  const sample = shaped(light, emitter.orientation, sampleShape(light, center, emitter.orientation, lighting.random));
  if (!sample) return undefined;
  const dx = inverseApparentPosition(sample.toward, emitter.frame.u);
  const time = at.t + rayBack(lighting, at, dx).dt / lighting.scene.c;
  if (!isAlive(light.lifetime, time)) return undefined;
  return { dx, rayDirection: dx, end: 1 - 1e-9, sourceSpectrum, sourceFrame: emitter.frame, weight: sample.weight };
}

function shaped({ shaping }: LocalLight, orientation: Quat, sample: LightSample | undefined): LightSample | undefined {
  if (!sample || !shaping) return sample;
  const front = rotate(orientation, [0, 0, -1]);
  const factor = shapingFactor(shaping, front, negate(normalize(sample.toward)));
  return factor > 0 ? { ...sample, weight: factor * sample.weight } : undefined;
}

interface EmittingLight {
  /** From the surface to the light's centre [m, world]. */
  readonly offset: Vec3;
  /** The light's rest frame and orientation at emission. */
  readonly frame: RestFrame;
  readonly orientation: Quat;
}

function lightAtEmission(
  lighting: LightingContext,
  { line, light }: MovingLight<LocalLight>,
  { t, x }: RayOrigin,
): EmittingLight | undefined {
  const { propagation, scene } = lighting;
  const { hypersurface, u } = propagation;
  const found = hypersurface.intersect(line, { t, position: x }, u, scene.c);
  if (!found) return undefined;
  const time = t + found.ahead / scene.c;
  const velocity = scale(velocityAt(line, time, scene.c), 1 / scene.c);
  const { orientation } = poseAt(light.motion, time, scene.c);
  return { offset: found.offset, frame: restFrameOf(lighting, velocity), orientation };
}
