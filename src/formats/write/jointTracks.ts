import { invert, type Mat4, multiply } from '../../math/mat4.ts';
import { matrixOfParts, partsOf, type TransformParts } from '../../math/transformParts.ts';

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
