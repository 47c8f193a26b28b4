import type { Springs } from './forces/springs.ts';
import { SystemError } from './system.ts';

/** How hard the springs of a mesh are [N/m]; 0 leaves them out. */
export interface NetStiffness {
  /** Along the edges. */
  readonly structural: number;
  /** Across faces of four and more corners. */
  readonly shear: number;
  /** Between what lies on both sides of an edge, and from neighbour to next neighbour. */
  readonly bending: number;
}

export interface Faces {
  /** Corners of each face. */
  readonly counts: ArrayLike<number>;
  /** Points of the corners, face after face. */
  readonly corners: ArrayLike<number>;
}

const MOST_SPRINGS = 10_000_000;

/**
 * The springs of a mesh, each pair of points once: structural along edges, shear along the diagonals of faces, bending from each point to the one beyond a neighbour (in
 * faces of four: straight on) or over an edge between triangles. At rest they are as long as they are in x, times `tension`.
 */
export function meshSprings(x: Float64Array, faces: Faces, stiffness: NetStiffness, tension = 1): Springs {
  const net = new Net(x.length / 3);
  const { structural, shear, bending } = stiffness;
  const polygons = polygonsOf(faces, x.length / 3);
  const edges = new Map<number, number[]>();
  polygons.forEach((polygon, f) => {
    polygon.forEach((a, k) => {
      const key = net.key(a, polygon[(k + 1) % polygon.length]);
      edges.set(key, [...(edges.get(key) ?? []), f]);
    });
  });
  for (const key of edges.keys()) net.add(key, structural);
  for (const polygon of polygons) for (const [a, b] of diagonals(polygon)) net.add(net.key(a, b), shear);
  if (bending > 0)
    for (const [key, sides] of edges)
      if (sides.length === 2)
        for (const [a, b] of across(
          net.ends(key),
          sides.map((f) => polygons[f]),
        ))
          net.add(net.key(a, b), bending);
  return net.springs(x, tension);
}

function polygonsOf({ counts, corners }: Faces, points: number): number[][] {
  let at = 0;
  return Array.from(counts, (count) => {
    const polygon = Array.from({ length: count }, (_, k) => corners[at + k]);
    at += count;
    const odd = polygon.find((point) => !(point >= 0 && point < points));
    if (odd !== undefined) throw new SystemError(`a face has point ${odd}, and there are ${points}`);
    return polygon;
  });
}

/** Pairs of corners that no side joins. */
function diagonals(polygon: readonly number[]): (readonly [number, number])[] {
  const n = polygon.length;
  return polygon.flatMap((a, i) =>
    polygon.flatMap((b, j) => (j > i + 1 && !(i === 0 && j === n - 1) ? [[a, b] as const] : [])),
  );
}

/** Of two faces with an edge between them: the pairs of corners, one of each face, that lie on both sides of an end of it. */
function across(
  [a, b]: readonly [number, number],
  faces: readonly (readonly number[])[],
): (readonly [number, number])[] {
  const [one, other] = faces.map((polygon) => {
    const beside = (of: number, not: number): number => {
      const k = polygon.indexOf(of);
      const [before, after] = [polygon[(k + polygon.length - 1) % polygon.length], polygon[(k + 1) % polygon.length]];
      return before === not ? after : before;
    };
    return [beside(a, b), beside(b, a)];
  });
  return [
    [one[0], other[0]],
    [one[1], other[1]],
  ];
}

/** Springs by their ends: the first that joins two points counts. */
class Net {
  private readonly points: number;
  private readonly stiffness = new Map<number, number>();

  constructor(points: number) {
    this.points = points;
  }

  key = (a: number, b: number): number => Math.min(a, b) * this.points + Math.max(a, b);
  ends = (key: number): readonly [number, number] => [Math.floor(key / this.points), key % this.points];

  add(key: number, k: number): void {
    const [a, b] = this.ends(key);
    if (!(k > 0) || a === b || this.stiffness.has(key)) return;
    this.stiffness.set(key, k);
    if (this.stiffness.size > MOST_SPRINGS)
      throw new SystemError(`the mesh makes more than ${MOST_SPRINGS} springs; take a coarser one`);
  }

  springs(x: Float64Array, tension: number): Springs {
    const keys = [...this.stiffness.keys()].sort((a, b) => a - b);
    const ends = Uint32Array.from(keys.flatMap((key) => this.ends(key)));
    const lengths = Float64Array.from(keys, (key) => {
      const [a, b] = this.ends(key);
      return tension * Math.hypot(x[3 * a] - x[3 * b], x[3 * a + 1] - x[3 * b + 1], x[3 * a + 2] - x[3 * b + 2]);
    });
    return { ends, stiffness: Float64Array.from(keys, (key) => this.stiffness.get(key)!), lengths };
  }
}
