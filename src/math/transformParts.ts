import { determinant, type Mat3 } from './mat3.ts';
import { fromParts, linearPart, type Mat4 } from './mat4.ts';
import {
  fromMatrix,
  multiply,
  IDENTITY as NO_TURN,
  type Quat,
  rotate,
  shortestRotation,
  slerp,
  toMatrix,
} from './quat.ts';
import { cross, dot, length, lerp, normalize, scale, type Vec3 } from './vec3.ts';

/** x′ = translation + rotation · (scale x): what formats have for joints and nodes. */
export interface TransformParts {
  readonly translation: Vec3;
  readonly rotation: Quat;
  readonly scale: Vec3;
}

/** The matrix of parts. */
export function matrixOfParts({ translation, rotation, scale: [x, y, z] }: TransformParts): Mat4 {
  const r = toMatrix(rotation);
  return fromParts(
    [r[0] * x, r[1] * y, r[2] * z, r[3] * x, r[4] * y, r[5] * z, r[6] * x, r[7] * y, r[8] * z],
    translation,
  );
}

/** Columns shorter than this, relative to the longest, have no direction. */
const FLAT = 1e-9;

/**
 * The parts of a matrix without shear; of one with shear, parts whose matrix has columns of the same lengths. A mirror is a negative scale along x.
 * `before`: the rotation where the matrix flattens space, as far as it leaves that open.
 */
export function partsOf(m: Mat4, before: Quat = NO_TURN): TransformParts {
  const l = linearPart(m);
  const columns = [0, 1, 2].map((c): Vec3 => [l[c], l[3 + c], l[6 + c]]);
  const [x, y, z] = columns.map(length);
  const most = Math.max(x, y, z);
  const known = [x, y, z].flatMap((size, c) => (size > most * FLAT ? [c] : []));
  const translation: Vec3 = [m[3], m[7], m[11]];
  if (known.length < 2) {
    const [c] = known;
    const turn = c === undefined ? NO_TURN : shortestRotation(rotate(before, AXES[c]), normalize(columns[c]));
    return { translation, rotation: multiply(turn, before), scale: [x, y, z] };
  }
  const axes = columns.map((column) => normalize(column));
  const missing = [0, 1, 2].find((c) => !known.includes(c));
  if (missing !== undefined) axes[missing] = cross(axes[(missing + 1) % 3], axes[(missing + 2) % 3]);
  const isMirror = determinant(fromColumns(axes)) < 0;
  if (isMirror) axes[0] = scale(axes[0], -1);
  return { translation, rotation: fromMatrix(fromColumns(orthonormal(axes))), scale: [isMirror ? -x : x, y, z] };
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

const fromColumns = ([a, b, c]: readonly Vec3[]): Mat3 => [a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]];

/** Gram–Schmidt. */
function orthonormal([a, b]: readonly Vec3[]): readonly Vec3[] {
  const second = normalize([0, 1, 2].map((i) => b[i] - dot(a, b) * a[i]) as unknown as Vec3);
  return [a, second, cross(a, second)];
}

/** Between two: translation and scale linear, the rotation along the shorter arc, as glTF and UsdSkel interpolate them. */
export const mixParts = (a: TransformParts, b: TransformParts, s: number): TransformParts => ({
  translation: lerp(a.translation, b.translation, s),
  rotation: slerp(a.rotation, b.rotation, s),
  scale: lerp(a.scale, b.scale, s),
});
