import { cornersAround } from '../mesh/polygons.ts';

/** From this value on an edge or point is sharp at every level (as in USD and OpenSubdiv). */
export const INFINITELY_SHARP = 10;

/**
 * Mesh connectivity. A corner is a face's index into its points; its edge runs to the face's next corner. Edges of
 * one face only, of more than two, or of two faces in the same direction are infinitely sharp.
 */
export interface SubdivisionTopology {
  readonly points: number;
  /** First corner of each face, and the number of corners. */
  readonly faceStarts: Uint32Array;
  readonly faceOfCorner: Uint32Array;
  /** The point of each corner. */
  readonly corners: Uint32Array;
  /** The edge from each corner. */
  readonly cornerEdges: Uint32Array;
  /** The corner of the opposite half-edge; −1: none. */
  readonly twins: Int32Array;
  /** Two per edge. */
  readonly edgePoints: Uint32Array;
  /** 0 is smooth. */
  readonly edgeSharpness: Float64Array;
  readonly pointSharpness: Float64Array;
}

/** Faces as runs of at least three corners, adjacent ones distinct; and their sharpness. */
export interface ControlCage {
  readonly points: number;
  readonly faceCounts: ArrayLike<number>;
  readonly faceIndices: ArrayLike<number>;
  /** Sharpness of an edge by its two points in either order; absent: all smooth. */
  readonly creaseSharpness?: (a: number, b: number) => number;
  /** By point. */
  readonly pointSharpness?: Float64Array;
  /** Points with a single face are fixed. */
  readonly sharpCorners: boolean;
}

export const nextCorner = ({ faceStarts, faceOfCorner }: SubdivisionTopology, corner: number): number =>
  corner + 1 < faceStarts[faceOfCorner[corner] + 1] ? corner + 1 : faceStarts[faceOfCorner[corner]];

export const previousCorner = ({ faceStarts, faceOfCorner }: SubdivisionTopology, corner: number): number => {
  const face = faceOfCorner[corner];
  return corner > faceStarts[face] ? corner - 1 : faceStarts[face + 1] - 1;
};

export function makeTopology(cage: ControlCage): SubdivisionTopology {
  const faceStarts = new Uint32Array(cage.faceCounts.length + 1);
  for (let f = 0; f < cage.faceCounts.length; f++) faceStarts[f + 1] = faceStarts[f] + cage.faceCounts[f];
  const corners = Uint32Array.from(cage.faceIndices);
  const faceOfCorner = new Uint32Array(corners.length);
  for (let f = 0; f < cage.faceCounts.length; f++) faceOfCorner.fill(f, faceStarts[f], faceStarts[f + 1]);
  const faces = { points: cage.points, faceStarts, faceOfCorner, corners };
  const edges = joinEdges(faces);
  const pointSharpness = Float64Array.from({ length: cage.points }, (_, p) => sharpnessOf(cage.pointSharpness?.[p]));
  const edgeSharpness = Float64Array.from(edges.broken, (isBroken, e) => {
    if (isBroken) return INFINITELY_SHARP;
    return sharpnessOf(cage.creaseSharpness?.(edges.edgePoints[2 * e], edges.edgePoints[2 * e + 1]));
  });
  const topology: SubdivisionTopology = { ...faces, ...edges, edgeSharpness, pointSharpness };
  sharpenPoints(topology, cage.sharpCorners, pointSharpness);
  return topology;
}

const sharpnessOf = (written = 0): number => (written > 0 ? Math.min(written, INFINITELY_SHARP) : 0);

type FaceCorners = Pick<SubdivisionTopology, 'points' | 'faceStarts' | 'faceOfCorner' | 'corners'>;

function joinEdges(faces: FaceCorners) {
  const { corners } = faces;
  const table = new EdgeTable(corners.length);
  const cornerEdges = new Uint32Array(corners.length);
  const twins = new Int32Array(corners.length).fill(-1);
  const first = new Int32Array(corners.length).fill(-1);
  const uses = new Uint32Array(corners.length);
  for (let c = 0; c < corners.length; c++) {
    const edge = table.edge(corners[c], corners[nextCorner(faces as SubdivisionTopology, c)]);
    cornerEdges[c] = edge;
    if (uses[edge]++ === 0) first[edge] = c;
    else if (uses[edge] === 2 && corners[first[edge]] !== corners[c]) {
      twins[c] = first[edge];
      twins[first[edge]] = c;
    }
  }
  for (let c = 0; c < corners.length; c++) if (uses[cornerEdges[c]] > 2) twins[c] = -1;
  const broken = new Uint8Array(table.size);
  for (let c = 0; c < corners.length; c++) if (twins[c] < 0) broken[cornerEdges[c]] = 1;
  return { cornerEdges, twins, edgePoints: table.points(), broken };
}

/** Point pairs, numbered in order of insertion; open addressing, since meshes have millions. */
class EdgeTable {
  size = 0;
  private readonly pairs: Uint32Array;
  private readonly slots: Int32Array;

  constructor(most: number) {
    this.pairs = new Uint32Array(2 * most);
    this.slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * most + 2))).fill(-1);
  }

  edge(p: number, q: number): number {
    const [a, b] = p < q ? [p, q] : [q, p];
    const mask = this.slots.length - 1;
    for (let slot = hash(a, b) & mask; ; slot = (slot + 1) & mask) {
      const edge = this.slots[slot];
      if (edge >= 0 && this.pairs[2 * edge] === a && this.pairs[2 * edge + 1] === b) return edge;
      if (edge >= 0) continue;
      this.slots[slot] = this.size;
      this.pairs.set([a, b], 2 * this.size);
      return this.size++;
    }
  }

  points(): Uint32Array {
    return this.pairs.slice(0, 2 * this.size);
  }
}

function hash(a: number, b: number): number {
  let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 15), 0xc2b2ae35);
  return h ^ (h >>> 13);
}

/** Fixes points without faces, with one face if `sharpCorners`, and non-manifold ones where fans of faces only touch. */
function sharpenPoints(topology: SubdivisionTopology, sharpCorners: boolean, sharpness: Float64Array): void {
  const around = cornersAround(topology.corners, topology.points);
  for (let p = 0; p < topology.points; p++) {
    const corners = around(p);
    const isAlone = corners.length === 0 || (corners.length === 1 && sharpCorners);
    if (isAlone || touchesOnly(topology, corners)) sharpness[p] = INFINITELY_SHARP;
  }
}

/** Whether a point has several closed fans; open ones are found by their edges. */
function touchesOnly(topology: SubdivisionTopology, corners: ArrayLike<number>): boolean {
  let walked = 0;
  let corner = corners[0];
  do {
    walked++;
    corner = topology.twins[previousCorner(topology, corner)];
  } while (corner >= 0 && corner !== corners[0] && walked <= corners.length);
  return corner === corners[0] && walked < corners.length;
}
