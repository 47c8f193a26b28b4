import { INFINITELY_SHARP, type SubdivisionTopology } from './topology.ts';

/** Rule of a point: smooth, on a crease of two sharp edges, or fixed. */
export type CreaseRule = 'smooth' | 'crease' | 'corner';

/** The sharp edges that meet at each point. */
export interface Creases {
  readonly counts: Uint32Array;
  /** Other ends of the first two of them. */
  readonly ends: Int32Array;
}

/** Sharpness after one level: 1 less unless infinitely sharp. */
export const decaySharpness = (sharpness: Float64Array): Float64Array =>
  sharpness.map((s) => (s >= INFINITELY_SHARP ? s : Math.max(0, s - 1)));

/** `least`: the sharpness from which an edge counts as sharp; absent: any above 0. */
export function creasesAt({ points, edgePoints }: SubdivisionTopology, sharpness: Float64Array, least = 0): Creases {
  const counts = new Uint32Array(points);
  const ends = new Int32Array(2 * points).fill(-1);
  for (let e = 0; e < sharpness.length; e++) {
    if (!(sharpness[e] > 0 && sharpness[e] >= least)) continue;
    const [a, b] = [edgePoints[2 * e], edgePoints[2 * e + 1]];
    if (counts[a] < 2) ends[2 * a + counts[a]] = b;
    if (counts[b] < 2) ends[2 * b + counts[b]] = a;
    counts[a]++;
    counts[b]++;
  }
  return { counts, ends };
}

/** A single sharp edge leaves the point smooth (a dart). */
export function creaseRule({ counts }: Creases, pointSharpness: Float64Array, point: number): CreaseRule {
  if (pointSharpness[point] > 0 || counts[point] > 2) return 'corner';
  return counts[point] === 2 ? 'crease' : 'smooth';
}

/** Weight of each point's current rule where its sharpness ends at the next level: the mean of what ends, at most 1. */
export function transitions(
  topology: SubdivisionTopology,
  next: { edges: Float64Array; points: Float64Array },
): Float64Array {
  const { points, edgePoints, edgeSharpness, pointSharpness } = topology;
  const sums = new Float64Array(points);
  const counts = new Uint32Array(points);
  const end = (point: number, sharpness: number): void => {
    sums[point] += sharpness;
    counts[point]++;
  };
  for (let e = 0; e < edgeSharpness.length; e++) {
    if (edgeSharpness[e] === 0 || next.edges[e] > 0) continue;
    end(edgePoints[2 * e], edgeSharpness[e]);
    end(edgePoints[2 * e + 1], edgeSharpness[e]);
  }
  for (let p = 0; p < points; p++) if (pointSharpness[p] > 0 && next.points[p] === 0) end(p, pointSharpness[p]);
  return sums.map((sum, p) => (counts[p] > 0 ? Math.min(1, sum / counts[p]) : 0));
}
