import { cofactors, determinant, type Mat3 } from '../math/mat3.ts';
import { linearPart, type Mat4 } from '../math/mat4.ts';
import type { Vec3 } from '../math/vec3.ts';

/** Points by M, 3 numbers each, into a new array, without an object for each. */
export const transformedPoints = (points: Float32Array, m: Mat4): Float32Array =>
  mapped(points, linearPart(m), [m[3], m[7], m[11]]);

/** Normals by the cofactors of M, made unit; turned with the faces where M mirrors. */
export function transformedNormals(normals: Float32Array, m: Mat4): Float32Array {
  const linear = linearPart(m);
  const sign = determinant(linear) < 0 ? -1 : 1;
  return madeUnit(
    mapped(
      normals,
      cofactors(linear).map((x) => x * sign),
      [0, 0, 0],
    ),
  );
}

function mapped(from: Float32Array, l: Mat3, t: Vec3): Float32Array {
  const out = new Float32Array(from.length);
  for (let i = 0; i < from.length; i += 3) {
    const x = from[i];
    const y = from[i + 1];
    const z = from[i + 2];
    out[i] = l[0] * x + l[1] * y + l[2] * z + t[0];
    out[i + 1] = l[3] * x + l[4] * y + l[5] * z + t[1];
    out[i + 2] = l[6] * x + l[7] * y + l[8] * z + t[2];
  }
  return out;
}

function madeUnit(normals: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i += 3) {
    const l = Math.sqrt(normals[i] ** 2 + normals[i + 1] ** 2 + normals[i + 2] ** 2);
    if (l > 0) for (let k = i; k < i + 3; k++) normals[k] /= l;
  }
  return normals;
}
