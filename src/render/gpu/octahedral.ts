import { abs, float, normalize, select, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float, Vec3 } from '../../shaders/types.ts';

/** See `encodeOctahedral` (packNormal.ts); for vectors that are not 0. */
export function encodeOctahedral(n: Vec3): Node<'vec2'> {
  const p = n.div(abs(n.x).add(abs(n.y)).add(abs(n.z))).toVar();
  return select(p.z.greaterThanEqual(0), p.xy, folded(p));
}

/** See `decodeOctahedral` (packNormal.ts). */
export function decodeOctahedral(p: Node<'vec2'>): Vec3 {
  const z = float(1).sub(abs(p.x)).sub(abs(p.y)).toVar();
  return normalize(vec3(select(z.greaterThanEqual(0), p, folded(p)), z));
}

const folded = (p: Vec3 | Node<'vec2'>): Node<'vec2'> =>
  vec2(abs(p.y).oneMinus().mul(signOrOne(p.x)), abs(p.x).oneMinus().mul(signOrOne(p.y)));
const signOrOne = (v: Float): Float => select(v.greaterThanEqual(0), float(1), float(-1));
