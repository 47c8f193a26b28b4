import { msg } from '../messages/message.ts';
import type { Springs } from './forces/springs.ts';
import { SystemError } from './system.ts';

/** Stiffness of a mesh's springs [N/m]; 0 omits them. */
export interface MeshStiffness {
  /** Along the edges. */
  readonly structural: number;
  /** Across faces with four or more corners. */
  readonly shear: number;
  /** Across edges between faces, and between second neighbours. */
  readonly bending: number;
}

/** The faces of a mesh. */
export interface FaceTopology {
  /** Number of corners of each face. */
  readonly counts: ArrayLike<number>;
  /** Point indices of the corners, face by face. */
  readonly corners: ArrayLike<number>;
}

const MAX_SPRINGS = 10_000_000;

/**
 * The springs of a mesh, each pair of points once: structural along edges; shear along face diagonals; bending from
 * each point to the one beyond a neighbour (in quads: straight on), or across the edge between two triangles. Rest
 * lengths are those in x times `tension`.
 * @example
 * // A square: four edges and two diagonals.
 * const x = Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
 * const faces = { counts: [4], corners: [0, 1, 2, 3] };
 * meshSprings(x, faces, { structural: 100, shear: 50, bending: 0 }).lengths.length; // 6
 */
export function meshSprings(x: Float64Array, faces: FaceTopology, stiffness: MeshStiffness, tension = 1): Springs {
  const points = x.length / 3;
  const sides = halfEdgesOf(faces, points);
  const order = sortPairs(sides.ends, points);
  const net = new SpringBuilder();
  for (let k = 0, end = 0; k < order.length; k = end) {
    end = endOfRun(sides.ends, order, k);
    net.add(sides.ends[2 * order[k]], sides.ends[2 * order[k] + 1], stiffness.structural);
  }
  addShearSprings(net, faces, stiffness.shear);
  for (let k = 0, end = 0; k < order.length; k = end) {
    end = endOfRun(sides.ends, order, k);
    if (end === k + 2) addBendingSprings(net, sides, faces.corners, order[k], order[k + 1], stiffness.bending);
  }
  return net.build(x, tension);
}

/** For each corner, the edge from it to the next corner of its face. */
interface HalfEdges {
  /** Lower and higher point index of each. */
  readonly ends: Uint32Array;
  /** Corners before and after each, around its face. */
  readonly before: Uint32Array;
  readonly after: Uint32Array;
}

function halfEdgesOf({ counts, corners }: FaceTopology, points: number): HalfEdges {
  const count = Array.prototype.reduce.call(counts, (sum, n) => (sum as number) + (n as number), 0) as number;
  const [ends, before, after] = [new Uint32Array(2 * count), new Uint32Array(count), new Uint32Array(count)];
  for (let f = 0, first = 0; f < counts.length; first += counts[f++])
    for (let k = 0; k < counts[f]; k++) {
      const corner = first + k;
      const point = corners[corner];
      if (!(point >= 0 && point < points))
        throw new SystemError(msg`a face has point ${point}, and there are ${points}`);
      after[corner] = first + ((k + 1) % counts[f]);
      before[after[corner]] = corner;
      const next = corners[after[corner]];
      ends[2 * corner] = Math.min(point, next);
      ends[2 * corner + 1] = Math.max(point, next);
    }
  return { ends, before, after };
}

/** Pairs of corners of a face that are not joined by an edge. */
function addShearSprings(net: SpringBuilder, { counts, corners }: FaceTopology, k: number): void {
  for (let f = 0, first = 0; f < counts.length; first += counts[f++])
    for (let i = 0; i < counts[f]; i++)
      for (let j = i + 2; j < counts[f]; j++)
        if (i > 0 || j < counts[f] - 1) net.add(corners[first + i], corners[first + j], k);
}

/** For two faces with a common edge: pairs of corners, one of each face, beyond an end of the edge. */
function addBendingSprings(
  net: SpringBuilder,
  sides: HalfEdges,
  corners: ArrayLike<number>,
  one: number,
  other: number,
  k: number,
): void {
  const [a, b] = [one, other].map((side) => {
    const [back, ahead] = [corners[sides.before[side]], corners[sides.after[sides.after[side]]]];
    return corners[side] === sides.ends[2 * side] ? [back, ahead] : [ahead, back];
  });
  net.add(a[0], b[0], k);
  net.add(a[1], b[1], k);
}

/** Springs by their ends; of several between two points the first counts. */
class SpringBuilder {
  /** Lower and higher end of each. */
  private readonly ends: number[] = [];
  private readonly stiffness: number[] = [];

  add(a: number, b: number, k: number): void {
    if (!(k > 0) || a === b) return;
    if (this.stiffness.length === MAX_SPRINGS)
      throw new SystemError(msg`the mesh makes more than ${MAX_SPRINGS} springs; take a coarser one`);
    this.ends.push(Math.min(a, b), Math.max(a, b));
    this.stiffness.push(k);
  }

  build(x: Float64Array, tension: number): Springs {
    const all = sortPairs(this.ends, x.length / 3);
    const order = all.filter((s, k) => k === 0 || !isSamePair(this.ends, all[k - 1], s));
    const ends = new Uint32Array(2 * order.length);
    const lengths = new Float64Array(order.length);
    order.forEach((s, k) => {
      const [a, b] = [this.ends[2 * s], this.ends[2 * s + 1]];
      ends.set([a, b], 2 * k);
      lengths[k] = tension * Math.hypot(x[3 * a] - x[3 * b], x[3 * a + 1] - x[3 * b + 1], x[3 * a + 2] - x[3 * b + 2]);
    });
    return { ends, stiffness: Float64Array.from(order, (s) => this.stiffness[s]), lengths };
  }
}

/** Permutation that sorts pairs by first, then second end; stable. A counting sort, linear in time. */
function sortPairs(ends: ArrayLike<number>, points: number): Uint32Array {
  let order = Uint32Array.from({ length: ends.length / 2 }, (_, s) => s);
  for (const end of [1, 0]) {
    const from = new Uint32Array(points + 1);
    for (const s of order) from[ends[2 * s + end] + 1]++;
    for (let i = 0; i < points; i++) from[i + 1] += from[i];
    const next = new Uint32Array(order.length);
    for (const s of order) next[from[ends[2 * s + end]]++] = s;
    order = next;
  }
  return order;
}

const isSamePair = (ends: ArrayLike<number>, s: number, t: number): boolean =>
  ends[2 * s] === ends[2 * t] && ends[2 * s + 1] === ends[2 * t + 1];

/** End of the run of pairs equal to the k-th. */
function endOfRun(ends: ArrayLike<number>, order: Uint32Array, k: number): number {
  let end = k + 1;
  while (end < order.length && isSamePair(ends, order[k], order[end])) end++;
  return end;
}
