import { clamp, dot, If, inverseSqrt, vec3 } from 'three/tsl';
import { aberrate } from '../../shaders/kinematics/aberrate.ts';
import { boost } from '../../shaders/kinematics/boost.ts';
import { observerDoppler } from '../../shaders/kinematics/observerDoppler.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import type { IncidentSpectrum } from '../color/radiance.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/** The rest frame of a surface or a light: directions of the world (towards where light comes from) as they are there, and back. */
export interface RestFrameNodes {
  into: (n: Vec3) => Vec3;
  out: (n: Vec3) => Vec3;
  /** The same of four-vectors (x, ct). */
  boostInto: (X: Vec4) => Vec4;
  boostOut: (X: Vec4) => Vec4;
  /** ν there/ν in the world of light from `n`; absent of what rests in the world. */
  doppler?: (n: Vec3) => Float;
}

export const WORLD_FRAME: RestFrameNodes = { into: (n) => n, out: (n) => n, boostInto: (X) => X, boostOut: (X) => X };

/** Of the velocity (v, 1 − v²); of the world in the views that show no light. Most surfaces rest: then nothing is computed. */
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
    into: (n) => where(n, () => aberrate(n, u, gamma)),
    out: (n) => where(n, () => unaberrate(n, u, gamma)),
    boostInto: (X) => boost(X, u, gamma),
    boostOut: (X) => boost(X, u.negate(), gamma),
    doppler: (n) => where(vec3(1), () => vec3(observerDoppler(n, u, gamma))).x,
  };
}

/** Of light from `n` (unit, world), from what rests in one frame to what rests in the other. */
export function incidentSpectrumBetween(n: Vec3, receiver: RestFrameNodes, source: RestFrameNodes): IncidentSpectrum {
  const [there, here] = [source.doppler?.(n), receiver.doppler?.(n)];
  if (!there) return here ? { D: here } : {};
  return { D: (here ? here.div(there) : there.reciprocal()).toVar() };
}
