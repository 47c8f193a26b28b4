import { vec3 } from 'three/tsl';
import type { Vec3 } from '../../../shaders/types.ts';

/** Luma, orange and green chroma. */
export const toYCoCg = ({ x: r, y: g, z: b }: Vec3): Vec3 =>
  vec3(r.add(b).mul(0.25).add(g.mul(0.5)), r.sub(b).mul(0.5), g.mul(0.5).sub(r.add(b).mul(0.25)));
export const fromYCoCg = ({ x: y, y: co, z: cg }: Vec3): Vec3 => vec3(y.add(co).sub(cg), y.add(cg), y.sub(co).sub(cg));
