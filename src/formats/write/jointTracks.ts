import { determinant, type Mat3 } from '../../math/mat3.ts';
import { fromParts, invert, linearPart, type Mat4, multiply } from '../../math/mat4.ts';
import {
  fromMatrix,
  multiply as multiplyQuat,
  IDENTITY as NO_TURN,
  type Quat,
  rotate,
  shortestRotation,
  slerp,
  toMatrix,
} from '../../math/quat.ts';
import { cross, dot, length, lerp, normalize, scale, type Vec3 } from '../../math/vec3.ts';

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
    return { translation, rotation: multiplyQuat(turn, before), scale: [x, y, z] };
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

/** The parts of each joint in its parent's axes, by sample; undefined if the joints shear what they carry by more than the tolerance. */
export function jointTracks(joints: JointFrames): readonly (readonly TransformParts[])[] | undefined {
  const { parents, samples, frameOf, reaches, tolerance } = joints;
  const order = parentsFirst(parents);
  const tracks = Array.from(parents, (): TransformParts[] => []);
  for (let k = 0; k < samples; k++) {
    const made: Mat4[] = [];
    for (const j of order) {
      const frame = frameOf(j, k);
      const above = parents[j] < 0 ? undefined : invert(made[parents[j]]);
      const before = tracks[j][k - 1];
      // Below a joint that has shrunk to nothing, all places are the same.
      const local = parents[j] < 0 ? frame : above && multiply(above, frame);
      const parts = local ? partsOf(local, before?.rotation) : (before ?? partsOf(frame));
      tracks[j].push(parts);
      const own = matrixOfParts(parts);
      made[j] = parents[j] < 0 ? own : multiply(made[parents[j]], own);
      if (!(distanceOf(made[j], frame, reaches[j]) <= tolerance)) return undefined;
    }
  }
  return tracks;
}

/** Joints at the samples of a motion. */
interface JointFrames {
  readonly parents: ArrayLike<number>;
  readonly samples: number;
  /** From the axes of joint j to those of all, at sample k. */
  frameOf(j: number, k: number): Mat4;
  /** By joint, how far from its origin is what follows it, in its axes. */
  readonly reaches: ArrayLike<number>;
  /** Greatest distance by which what follows a joint may be off. */
  readonly tolerance: number;
}

/** Indices of joints such that each comes after its parent. */
export function parentsFirst(parents: ArrayLike<number>): readonly number[] {
  const depths = depthsOf(parents);
  return Array.from(parents, (_, j) => j).sort((a, b) => depths[a] - depths[b]);
}

/** By joint, how many are above it. */
export function depthsOf(parents: ArrayLike<number>): readonly number[] {
  const depths: number[] = [];
  const depthOf = (j: number): number => {
    const above: number[] = [];
    let i = j;
    for (; i >= 0 && depths[i] === undefined; i = parents[i]) above.push(i);
    let depth = i >= 0 ? depths[i] + 1 : 0;
    for (const each of above.reverse()) depths[each] = depth++;
    return depths[j];
  };
  for (let j = 0; j < parents.length; j++) depthOf(j);
  return depths;
}

/** A bound of the distance between two places of a point that is at most `reach` from the origin. */
export function distanceOf(a: Mat4, b: Mat4, reach: number): number {
  let [linear, shift] = [0, 0];
  for (let row = 0; row < 12; row += 4) {
    for (let c = 0; c < 3; c++) linear += (a[row + c] - b[row + c]) ** 2;
    shift += (a[row + 3] - b[row + 3]) ** 2;
  }
  return Math.sqrt(shift) + Math.sqrt(linear) * reach;
}

/**
 * The samples that are kept as keys: as few as one after the other as far ahead as those between them are close enough to the interpolation of the two.
 * The first and the last are kept.
 */
export function keptKeys(samples: number, isClose: (from: number, to: number) => boolean): readonly number[] {
  const keys = [0];
  for (let from = 0; from < samples - 1; from = keys[keys.length - 1]) {
    const reaches = (step: number): boolean => step === 1 || isClose(from, from + step);
    const left = samples - 1 - from;
    // By doubling, then by halving.
    let step = 1;
    while (2 * step <= left && reaches(2 * step)) step *= 2;
    let beyond = Math.min(2 * step, left + 1);
    while (beyond - step > 1) {
      const middle = Math.floor((step + beyond) / 2);
      if (reaches(middle)) step = middle;
      else beyond = middle;
    }
    keys.push(from + step);
  }
  return keys;
}
