import { clamp, dot, If, inverseSqrt, vec3 } from 'three/tsl';
import { aberrate } from '../shaders/aberrate.ts';
import { observerDoppler } from '../shaders/observerDoppler.ts';
import type { Float, Vec3, Vec4 } from '../shaders/types.ts';
import { unaberrate } from '../shaders/unaberrate.ts';
import { met, seen } from './radiance.ts';
import type { Uniforms } from './uniforms.ts';

/** The surface's rest frame: directions of the world as they are there, and back, and light from a world direction as it meets it. */
export interface Rest {
  into: (n: Vec3) => Vec3;
  out: (n: Vec3) => Vec3;
  radiance: (rgb: Vec3, n: Vec3) => Vec3;
  irradiance: (rgb: Vec3, n: Vec3) => Vec3;
}

export const AT_REST: Rest = { into: (n) => n, out: (n) => n, radiance: (rgb) => rgb, irradiance: (rgb) => rgb };

/** Most surfaces rest: then nothing is computed. */
export function restFrame(velocity: Vec4, uniforms: Uniforms): Rest {
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
  const doppler = (n: Vec3): Float => where(vec3(1), () => vec3(observerDoppler(n, u, gamma))).x;
  return {
    into: (n) => where(n, () => aberrate(n, u, gamma)),
    out: (n) => where(n, () => unaberrate(n, u, gamma)),
    radiance: (rgb, n) => seen(rgb, doppler(n), uniforms),
    irradiance: (rgb, n) => met(rgb, doppler(n), uniforms),
  };
}
