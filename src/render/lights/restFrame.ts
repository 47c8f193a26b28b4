import { clamp, dot, If, inverseSqrt, vec3 } from 'three/tsl';
import { aberrate } from '../../shaders/kinematics/aberrate.ts';
import { boost } from '../../shaders/kinematics/boost.ts';
import { observerDoppler } from '../../shaders/kinematics/observerDoppler.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Bool, Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { IncidentSpectrum } from '../color/radiance.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/** Transformations between the world and the rest frame of a surface or a light. */
export interface RestFrameNodes {
  /** Directions towards a source, world → rest frame and back. */
  into: (n: Vec3) => Vec3;
  out: (n: Vec3) => Vec3;
  /** The same for four-vectors (x, ct). */
  boostInto: (X: Vec4) => Vec4;
  boostOut: (X: Vec4) => Vec4;
  /** ν in the rest frame over ν in the world, for light from `n`; absent at rest. */
  doppler?: (n: Vec3) => Float;
  /** Absent at rest. */
  readonly motion?: RestFrameMotion;
}

/** γβ and γ of a rest frame; `moving`: whether what it sees of the sky differs. */
export interface RestFrameMotion {
  readonly u: Vec3;
  readonly gamma: Float;
  readonly moving: Bool;
}

/** Square of the γβ below which the sky's light is that at rest, to 2 · 10⁻⁴. */
const MIN_SQUARE = 1e-8;

export const WORLD_FRAME: RestFrameNodes = { into: (n) => n, out: (n) => n, boostInto: (X) => X, boostOut: (X) => X };

/** For the velocity (v, 1 − v²); in views where light is not shifted that of the world. At rest, as most surfaces are, the boosts are skipped. */
export function restFrame(velocity: Vec4, uniforms: FrameUniforms): RestFrameNodes {
  const gamma = inverseSqrt(clamp(velocity.w, 1e-12, 1)).toVar();
  const u = velocity.xyz.mul(gamma).mul(uniforms.boostLight).toVar();
  const moving = dot(u, u).greaterThan(0).toVar();
  const where = (rest: Vec3, moved: () => Vec3): Vec3 => {
    const value = rest.toVar();
    If(moving, () => {
      value.assign(moved());
    });
    return value;
  };
  return {
    motion: { u, gamma, moving: dot(u, u).greaterThan(MIN_SQUARE).toVar() },
    into: (n) => where(n, () => aberrate(n, u, gamma)),
    out: (n) => where(n, () => unaberrate(n, u, gamma)),
    boostInto: (X) => boost(X, u, gamma),
    boostOut: (X) => boost(X, u.negate(), gamma),
    doppler: (n) => where(vec3(1), () => vec3(observerDoppler(n, u, gamma))).x,
  };
}

/** D of light from the world direction `n` (unit) that is emitted at rest in `source` and received at rest in `receiver`. */
export function incidentSpectrumBetween(n: Vec3, receiver: RestFrameNodes, source: RestFrameNodes): IncidentSpectrum {
  const [there, here] = [source.doppler?.(n), receiver.doppler?.(n)];
  if (!there) return here ? { D: here } : {};
  return { D: (here ? here.div(there) : there.reciprocal()).toVar() };
}
