import { cofactors, determinant, type Mat3 } from '../../math/mat3.ts';
import { linearPart, type Mat4 } from '../../math/mat4.ts';
import { norm, type Vec3, ZERO } from '../../math/vec3.ts';

/** Transforms points, 3 numbers each, to M x in place, because long caches have many. */
export const transformPointsInPlace = (points: Float32Array, m: Mat4): Float32Array =>
  applyInPlace(points, linearPart(m), [m[3], m[7], m[11]]);

/** Transforms normals by the cofactors of M and normalizes them, in place; reversed like the faces if M is a reflection. */
export function transformNormalsInPlace(normals: Float32Array, m: Mat4): Float32Array {
  const linear = linearPart(m);
  const sign = determinant(linear) < 0 ? -1 : 1;
  const turned = cofactors(linear).map((x) => x * sign);
  return normalizeInPlace(applyInPlace(normals, turned, ZERO));
}

function applyInPlace(vectors: Float32Array, linear: Mat3, [tx, ty, tz]: Vec3): Float32Array {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = linear;
  for (let i = 0; i < vectors.length; i += 3) {
    const x = vectors[i];
    const y = vectors[i + 1];
    const z = vectors[i + 2];
    vectors[i] = xx * x + xy * y + xz * z + tx;
    vectors[i + 1] = yx * x + yy * y + yz * z + ty;
    vectors[i + 2] = zx * x + zy * y + zz * z + tz;
  }
  return vectors;
}

/** Normalizes vectors, 3 numbers each, in place; zero vectors stay. */
export function normalizeInPlace(vectors: Float32Array): Float32Array {
  for (let i = 0; i < vectors.length; i += 3) {
    const l = norm(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (!(l > 0)) continue;
    vectors[i] /= l;
    vectors[i + 1] /= l;
    vectors[i + 2] /= l;
  }
  return vectors;
}
