import { cornersAround } from '../mesh/polygons.ts';
import { loopWeight } from './masks.ts';
import { creaseRule, creasesAt } from './rules.ts';
import { isLinear, type SubdivisionScheme } from './scheme.ts';
import { type SparseMatrix, SparseMatrixBuilder } from './sparseMatrix.ts';
import { nextCorner, previousCorner, type SubdivisionTopology } from './topology.ts';

/**
 * Limit positions and tangents of a refined mesh (all quads, or all triangles). Sharp edges divide the faces around a
 * point; each division has its own tangents and is called a slot.
 */
export interface LimitMatrices {
  /** By point. */
  readonly positions: SparseMatrix;
  /** Per slot; along × across points to the side from which the faces are counter-clockwise. */
  readonly along: SparseMatrix;
  readonly across: SparseMatrix;
  readonly slotOfCorner: Uint32Array;
  readonly pointOfSlot: Uint32Array;
}

/** Minimum sharpness after the last level at which an edge is treated as sharp. */
const LOOKS_SHARP = 1;

/** Limit masks: Halstead et al. (1993) for Catmull–Clark, Loop (1987); on creases derived here, as Biermann et al. (2000) do. */
export function limitMatrices(topology: SubdivisionTopology, scheme: SubdivisionScheme): LimitMatrices {
  const around = cornersAround(topology.corners, topology.points);
  return { positions: positionRows(topology, scheme, around), ...tangentRows(topology, scheme, around) };
}

/** The limit positions alone. */
export function limitPositions(topology: SubdivisionTopology, scheme: SubdivisionScheme): SparseMatrix {
  return positionRows(topology, scheme, cornersAround(topology.corners, topology.points));
}

type CornersOfPoint = (point: number) => Uint32Array;

function positionRows(topology: SubdivisionTopology, scheme: SubdivisionScheme, around: CornersOfPoint): SparseMatrix {
  const creases = creasesAt(topology, topology.edgeSharpness);
  const rows = new SparseMatrixBuilder(topology.points, scheme === 'loop' ? 7 : 9);
  for (let p = 0; p < topology.points; p++) {
    const rule = isLinear(scheme) ? 'corner' : creaseRule(creases, topology.pointSharpness, p);
    if (rule === 'corner') rows.add(p, 1);
    else if (rule === 'crease') {
      rows.add(p, 2 / 3);
      rows.add(creases.ends[2 * p], 1 / 6);
      rows.add(creases.ends[2 * p + 1], 1 / 6);
    } else if (scheme === 'loop') addSmoothLoop(rows, topology, p, around(p));
    else addSmoothCatmullClark(rows, topology, p, around(p));
    rows.endRow();
  }
  return rows.build();
}

function addSmoothCatmullClark(
  rows: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  p: number,
  corners: Uint32Array,
): void {
  const n = corners.length;
  rows.add(p, n / (n + 5));
  for (const c of corners) {
    const next = nextCorner(topology, c);
    rows.add(topology.corners[next], 4 / (n * (n + 5)));
    rows.add(topology.corners[nextCorner(topology, next)], 1 / (n * (n + 5)));
  }
}

function addSmoothLoop(
  rows: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  p: number,
  corners: Uint32Array,
): void {
  const n = corners.length;
  const own = 3 / (8 * loopWeight(n));
  rows.add(p, own / (own + n));
  for (const c of corners) rows.add(topology.corners[nextCorner(topology, c)], 1 / (own + n));
}

function tangentRows(topology: SubdivisionTopology, scheme: SubdivisionScheme, around: CornersOfPoint) {
  const isBreak = (edge: number): boolean => isLinear(scheme) || topology.edgeSharpness[edge] >= LOOKS_SHARP;
  const creases = creasesAt(topology, topology.edgeSharpness, LOOKS_SHARP);
  const slotOfCorner = new Uint32Array(topology.corners.length);
  const pointOfSlot: number[] = [];
  const maxSlots = topology.corners.length + 1;
  const [along, across] = [new SparseMatrixBuilder(maxSlots, 3), new SparseMatrixBuilder(maxSlots, 3)];
  for (let p = 0; p < topology.points; p++) {
    const isFixed = topology.pointSharpness[p] >= LOOKS_SHARP || creases.counts[p] > 2 || isLinear(scheme);
    const corners = around(p);
    // The usual case; meshes have millions of such points.
    const isSmooth = !isFixed && creases.counts[p] === 0 && corners.length > 0;
    for (const fan of isSmooth ? [wholeFan(topology, corners)] : fansOf(topology, corners, isBreak)) {
      for (const c of fan.corners) slotOfCorner[c] = pointOfSlot.length;
      pointOfSlot.push(p);
      addTangents(along, across, topology, scheme, p, fan, isFixed);
      along.endRow();
      across.endRow();
    }
  }
  return {
    along: along.build(),
    across: across.build(),
    slotOfCorner,
    pointOfSlot: Uint32Array.from(pointOfSlot),
  };
}

/** The corners around a point, counter-clockwise, between two sharp edges; or all of them. */
interface Fan {
  readonly corners: number[];
  readonly isClosed: boolean;
}

/** The fan of a point without sharp edges. */
function wholeFan(topology: SubdivisionTopology, corners: Uint32Array): Fan {
  const fan: number[] = [];
  for (let c = corners[0]; fan.length < corners.length; c = topology.twins[previousCorner(topology, c)]) fan.push(c);
  return { corners: fan, isClosed: true };
}

function fansOf(topology: SubdivisionTopology, corners: Uint32Array, isBreak: (edge: number) => boolean): Fan[] {
  const { cornerEdges, twins } = topology;
  const walk = (first: number): Fan => {
    const fan: number[] = [];
    for (let c = first; fan.length < corners.length; ) {
      fan.push(c);
      const before = previousCorner(topology, c);
      if (isBreak(cornerEdges[before])) return { corners: fan, isClosed: false };
      c = twins[before];
      if (c === first) break;
    }
    return { corners: fan, isClosed: true };
  };
  const starts = corners.filter((c) => isBreak(cornerEdges[c]));
  const fans = Array.from(starts, walk);
  // A single sharp edge that ends at the point does not divide its faces.
  const reached = fans.reduce((sum, fan) => sum + fan.corners.length, 0);
  if (starts.length === 1 && reached === corners.length && isDart(topology, fans[0])) {
    return [{ corners: fans[0].corners, isClosed: true }];
  }
  if (reached === corners.length) return fans;
  const left = new Set(corners);
  for (const fan of fans) for (const c of fan.corners) left.delete(c);
  for (const c of left) {
    const fan = walk(c);
    for (const reachedCorner of fan.corners) left.delete(reachedCorner);
    fans.push(fan);
  }
  return fans;
}

/** Whether the fan begins and ends at the same edge. */
function isDart(topology: SubdivisionTopology, { corners }: Fan): boolean {
  return topology.twins[previousCorner(topology, corners[corners.length - 1])] === corners[0];
}

function addTangents(
  along: SparseMatrixBuilder,
  across: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  scheme: SubdivisionScheme,
  p: number,
  fan: Fan,
  isFixed: boolean,
): void {
  const edges = fan.corners.map((c) => topology.corners[nextCorner(topology, c)]);
  const last = fan.corners[fan.corners.length - 1];
  if (!fan.isClosed) edges.push(topology.corners[previousCorner(topology, last)]);
  const opposite = (i: number): number => topology.corners[nextCorner(topology, nextCorner(topology, fan.corners[i]))];
  const withOpposite = scheme === 'catmullClark' ? opposite : undefined;
  if (fan.isClosed) addSmoothTangents(along, across, edges, withOpposite);
  else if (isFixed) addCornerTangents(along, across, p, edges);
  else addCreaseTangents(along, across, p, edges, withOpposite);
}

type Opposite = ((i: number) => number) | undefined;

/** Tangents of a smooth point: the first Fourier mode over its edges and, for quads, the points across its faces. */
function addSmoothTangents(
  along: SparseMatrixBuilder,
  across: SparseMatrixBuilder,
  edges: number[],
  opposite: Opposite,
): void {
  const { edge, cosines, sines, face } = waveOf(edges.length);
  const ofEdge = opposite ? edge : 1;
  for (let i = 0; i < edges.length; i++) {
    along.add(edges[i], ofEdge * cosines[i]);
    across.add(edges[i], ofEdge * sines[i]);
    if (!opposite) continue;
    const point = opposite(i);
    along.add(point, face.cosines[i]);
    across.add(point, face.sines[i]);
  }
}

interface Wave {
  /** Weight of an edge between quads. */
  readonly edge: number;
  readonly cosines: readonly number[];
  readonly sines: readonly number[];
  /** For face points, which lie between neighbouring edges: sums of the two edges' values. */
  readonly face: { readonly cosines: readonly number[]; readonly sines: readonly number[] };
}
const waves = new Map<number, Wave>();

function waveOf(n: number): Wave {
  const known = waves.get(n);
  if (known) return known;
  const turn = (2 * Math.PI) / n;
  const cosines = Array.from({ length: n + 1 }, (_, i) => Math.cos(i * turn));
  const sines = Array.from({ length: n + 1 }, (_, i) => Math.sin(i * turn));
  const sums = (values: readonly number[]): number[] => values.slice(0, n).map((x, i) => x + values[i + 1]);
  const edge = 1 + Math.cos(turn) + Math.cos(turn / 2) * Math.sqrt(2 * (9 + Math.cos(turn)));
  const wave = { edge, cosines, sines, face: { cosines: sums(cosines), sines: sums(sines) } };
  if (n <= MAX_CACHED_EDGES) waves.set(n, wave);
  return wave;
}
/** Modes are cached up to this valence. */
const MAX_CACHED_EDGES = 32;

/** Tangents of a corner point: its edges; exact for one face, for two along the sum of both faces' normals. */
function addCornerTangents(along: SparseMatrixBuilder, across: SparseMatrixBuilder, p: number, edges: number[]): void {
  const last = edges.length - 1;
  along.add(edges[0], 1);
  along.add(last > 1 ? edges[last] : p, -1);
  across.add(edges[last > 1 ? Math.ceil(last / 2) : 1], 1);
  across.add(p, -1);
}

/** Tangents of a crease point: from one end of the crease to the other, and into the faces beside it. */
function addCreaseTangents(
  along: SparseMatrixBuilder,
  across: SparseMatrixBuilder,
  p: number,
  edges: number[],
  opposite: Opposite,
): void {
  const faces = edges.length - 1;
  along.add(edges[0], 1);
  along.add(edges[faces], -1);
  if (faces === 1) {
    across.add(edges[0], 1);
    across.add(edges[1], 1);
    across.add(p, -2);
  } else if (opposite) addQuadsAcross(across, p, edges, opposite);
  else addTrianglesAcross(across, p, edges);
}

/** Into the faces: sin(iθ) over the inner edges, a left eigenvector of the local subdivision matrix. */
function addQuadsAcross(
  across: SparseMatrixBuilder,
  p: number,
  edges: number[],
  opposite: (i: number) => number,
): void {
  const faces = edges.length - 1;
  const theta = Math.PI / faces;
  const c = 1 + Math.cos(theta);
  const ofEdge = c + Math.sqrt(c * (8 + c));
  const eigenvalue = (4 + ofEdge) / 16;
  let sum = 0;
  for (let i = 0; i < faces; i++) {
    across.add(edges[i], i > 0 ? ofEdge * Math.sin(i * theta) : 0);
    across.add(opposite(i), Math.sin(i * theta) + Math.sin((i + 1) * theta));
    sum += Math.sin(i * theta);
  }
  addCreaseItself(across, p, edges, eigenvalue, sum * ((3 / 8) * ofEdge + 1 / 2), 8 * eigenvalue * Math.sin(theta));
}

function addTrianglesAcross(across: SparseMatrixBuilder, p: number, edges: number[]): void {
  const faces = edges.length - 1;
  const theta = Math.PI / faces;
  let sum = 0;
  for (let i = 1; i < faces; i++) {
    across.add(edges[i], Math.sin(i * theta));
    sum += Math.sin(i * theta);
  }
  addCreaseItself(across, p, edges, 3 / 8 + Math.cos(theta) / 4, (3 / 8) * sum, Math.sin(theta));
}

/**
 * The eigenvector at the point, w, and at both ends of its crease, u. By the masks 3/4, 1/8 and 1/2, 1/2: λ u = u/2 +
 * w/8 + `end`/8 and λ w = 3w/4 + u + `inner`, where the inner edges and faces add `end` and `inner`.
 */
function addCreaseItself(
  across: SparseMatrixBuilder,
  p: number,
  edges: number[],
  eigenvalue: number,
  inner: number,
  end: number,
): void {
  const u = (inner + end * (eigenvalue - 3 / 4)) / (8 * (eigenvalue - 1 / 2) * (eigenvalue - 3 / 4) - 1);
  across.add(p, 8 * u * (eigenvalue - 1 / 2) - end);
  across.add(edges[0], u);
  across.add(edges[edges.length - 1], u);
}
