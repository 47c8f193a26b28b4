import { cornersAround } from '../mesh/polygons.ts';
import { type CreaseRule, type Creases, creaseRule, creasesAt, decaySharpness, transitions } from './rules.ts';
import { isLinear, type SubdivisionScheme, splitsTriangles } from './scheme.ts';
import { type SparseMatrix, SparseMatrixBuilder } from './sparseMatrix.ts';
import { nextCorner, previousCorner, type SubdivisionTopology } from './topology.ts';

/** One level of refinement: face points from the points, then the next level's points from the points followed by the face points. */
export interface RefinementStep {
  /** Empty where the scheme does not use face points. */
  readonly middles: SparseMatrix;
  readonly children: SparseMatrix;
}

/** Weight of a triangle's face point at its edges with smooth triangles (Stam and Loop 2003; of a quad 1/4). */
const SMOOTH_TRIANGLE = 0.47;

/**
 * The masks of Catmull and Clark (1978) and Loop (1987), with the creases of Hoppe et al. (1994) and DeRose et al.
 * (1998): a sharp edge's point is its midpoint, a crease point 3/4 of itself and 1/8 of each end, a corner stays.
 * Where sharpness ends between two levels, the masks before and after are blended.
 */
export function refinementStep(
  topology: SubdivisionTopology,
  scheme: SubdivisionScheme,
  smoothTriangles = false,
): RefinementStep {
  const edges = topology.edgePoints.length / 2;
  const faces = topology.faceStarts.length - 1;
  const usesMiddles = !splitsTriangles(scheme);
  const rows = new SparseMatrixBuilder(topology.points + edges + (usesMiddles ? faces : 0), 6);
  addPointRows(rows, topology, scheme);
  addEdgeRows(rows, topology, scheme, smoothTriangles);
  for (let f = 0; usesMiddles && f < faces; f++) {
    rows.add(topology.points + f, 1);
    rows.endRow();
  }
  return { middles: usesMiddles ? middlesOf(topology) : new SparseMatrixBuilder(0, 0).build(), children: rows.build() };
}

function middlesOf({ faceStarts, corners }: SubdivisionTopology): SparseMatrix {
  const rows = new SparseMatrixBuilder(faceStarts.length - 1, 4);
  for (let f = 0; f + 1 < faceStarts.length; f++) {
    const [from, to] = [faceStarts[f], faceStarts[f + 1]];
    for (let c = from; c < to; c++) rows.add(corners[c], 1 / (to - from));
    rows.endRow();
  }
  return rows.build();
}

function addPointRows(rows: SparseMatrixBuilder, topology: SubdivisionTopology, scheme: SubdivisionScheme): void {
  const { edgeSharpness, pointSharpness } = topology;
  const next = { edges: decaySharpness(edgeSharpness), points: decaySharpness(pointSharpness) };
  const [now, later] = [creasesAt(topology, edgeSharpness), creasesAt(topology, next.edges)];
  const left = transitions(topology, next);
  const around = cornersAround(topology.corners, topology.points);
  const add = (rule: CreaseRule, creases: Creases, p: number, weight: number): void => {
    if (weight === 0) return;
    if (rule === 'corner' || isLinear(scheme)) rows.add(p, weight);
    else if (rule === 'crease') addCrease(rows, creases, p, weight);
    else if (scheme === 'loop') addSmoothLoop(rows, topology, p, around(p), weight);
    else addSmoothCatmullClark(rows, topology, p, around(p), weight);
  };
  for (let p = 0; p < topology.points; p++) {
    const [before, after] = [creaseRule(now, pointSharpness, p), creaseRule(later, next.points, p)];
    const part = before === after ? 0 : left[p];
    add(before, now, p, part);
    add(after, later, p, 1 - part);
    rows.endRow();
  }
}

function addCrease(rows: SparseMatrixBuilder, { ends }: Creases, p: number, weight: number): void {
  rows.add(p, 0.75 * weight);
  rows.add(ends[2 * p], 0.125 * weight);
  rows.add(ends[2 * p + 1], 0.125 * weight);
}

function addSmoothCatmullClark(
  rows: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  p: number,
  around: Uint32Array,
  weight: number,
): void {
  const n = around.length;
  rows.add(p, ((n - 2) / n) * weight);
  for (const c of around) {
    rows.add(topology.corners[nextCorner(topology, c)], weight / (n * n));
    rows.add(topology.points + topology.faceOfCorner[c], weight / (n * n));
  }
}

/** Loop's weight of each neighbour of a smooth point of valence `n`. */
export const loopWeight = (n: number): number => (5 / 8 - (3 / 8 + Math.cos((2 * Math.PI) / n) / 4) ** 2) / n;

function addSmoothLoop(
  rows: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  p: number,
  around: Uint32Array,
  weight: number,
): void {
  const each = loopWeight(around.length);
  rows.add(p, (1 - around.length * each) * weight);
  for (const c of around) rows.add(topology.corners[nextCorner(topology, c)], each * weight);
}

function addEdgeRows(
  rows: SparseMatrixBuilder,
  topology: SubdivisionTopology,
  scheme: SubdivisionScheme,
  smoothTriangles: boolean,
): void {
  const { edgePoints, edgeSharpness, cornerEdges, twins, corners, points, faceOfCorner } = topology;
  const cornerOf = new Int32Array(edgeSharpness.length).fill(-1);
  for (let c = 0; c < cornerEdges.length; c++) cornerOf[cornerEdges[c]] = c;
  for (let e = 0; e < edgeSharpness.length; e++) {
    const sharp = isLinear(scheme) ? 1 : Math.min(1, edgeSharpness[e]);
    const sides = sharp < 1 ? [cornerOf[e], twins[cornerOf[e]]] : [];
    const weight =
      scheme === 'loop' ? 1 / 8 : sides.reduce((sum, c) => sum + sideWeight(topology, c, smoothTriangles), 0) / 2;
    const ofEnds = sharp / 2 + (1 - sharp) * (0.5 - weight);
    rows.add(edgePoints[2 * e], ofEnds);
    rows.add(edgePoints[2 * e + 1], ofEnds);
    for (const c of sides) {
      const column = scheme === 'loop' ? corners[previousCorner(topology, c)] : points + faceOfCorner[c];
      rows.add(column, (1 - sharp) * weight);
    }
    rows.endRow();
  }
}

function sideWeight(
  { faceStarts, faceOfCorner }: SubdivisionTopology,
  corner: number,
  smoothTriangles: boolean,
): number {
  const face = faceOfCorner[corner];
  return smoothTriangles && faceStarts[face + 1] - faceStarts[face] === 3 ? SMOOTH_TRIANGLE : 1 / 4;
}
