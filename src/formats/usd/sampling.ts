import type { Mat4 } from '../../math/mat4.ts';
import { transformPoint } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';

/**
 * Where a path between samples is compared with its chord: at irregular fractions, so that whole turns between two
 * samples (which look like rest at the half) are found.
 */
const PROBES = [0.118, 0.283, 0.5, 0.691, 0.877];
/** One interval is halved at most this often, and one object gets at most so many samples. */
const MAX_HALVINGS = 14;
const MAX_SAMPLES = 50_000;

export interface RefinedTimes {
  readonly times: Float64Array;
  /** Greatest distance from a chord that is left, in the matrices' units. */
  readonly error: number;
}

/**
 * Adds times between samples until the points `corners`, carried by `matrixAt`, move along chords to `tolerance`. Poses
 * between samples are those that the transform's own ops give (angles turn evenly), not a blend of the samples' poses.
 */
export function refineTimes(
  samples: Float64Array,
  matrixAt: (time: number) => Mat4,
  corners: readonly Vec3[],
  tolerance: number,
): RefinedTimes {
  const times: number[] = [];
  let error = 0;
  const visit = (a: number, b: number, halvings: number): void => {
    const off = chordError(a, b, matrixAt, corners);
    const middle = (a + b) / 2;
    if (off <= tolerance || halvings === 0 || times.length >= MAX_SAMPLES || middle <= a || middle >= b) {
      error = Math.max(error, off);
      times.push(a);
      return;
    }
    visit(a, middle, halvings - 1);
    visit(middle, b, halvings - 1);
  };
  for (let i = 0; i + 1 < samples.length; i++) visit(samples[i], samples[i + 1], MAX_HALVINGS);
  times.push(samples[samples.length - 1]);
  return { times: Float64Array.from(times), error };
}

function chordError(a: number, b: number, matrixAt: (time: number) => Mat4, corners: readonly Vec3[]): number {
  const [from, to] = [matrixAt(a), matrixAt(b)];
  let worst = 0;
  for (const s of PROBES) {
    const m = matrixAt(a + (b - a) * s);
    const off = m.map((x, i) => x - (1 - s) * from[i] - s * to[i]);
    for (const corner of corners) worst = Math.max(worst, Math.hypot(...transformPoint(off, corner)));
  }
  return worst;
}

/** The eight corners of the box around points. */
export function boxCorners(points: ArrayLike<number>): Vec3[] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const k = i % 3;
    if (points[i] < low[k]) low[k] = points[i];
    if (points[i] > high[k]) high[k] = points[i];
  }
  if (!low.every(Number.isFinite) || !high.every(Number.isFinite)) return [[0, 0, 0]];
  return Array.from({ length: 8 }, (_, i): Vec3 => {
    const at = (k: number): number => ((i >> k) & 1 ? high[k] : low[k]);
    return [at(0), at(1), at(2)];
  });
}

/** Memory of a deforming mesh: a position and a normal of three f32 for each vertex at each time. */
export const bytesOfPoints = (times: number, vertices: number): number => times * vertices * 24;

/** As many of the times as `bytes` hold, evenly chosen, with the first and the last; at least these two. */
export function affordableTimes(times: Float64Array, vertices: number, bytes: number): Float64Array {
  const most = Math.max(2, Math.floor(bytes / bytesOfPoints(1, vertices)));
  if (times.length <= most) return times;
  return Float64Array.from({ length: most }, (_, i) => times[Math.round((i * (times.length - 1)) / (most - 1))]);
}
