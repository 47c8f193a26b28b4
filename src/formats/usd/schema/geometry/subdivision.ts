import { listed, msg } from '../../../../messages/message.ts';
import type { Polygons } from '../../../../scene/mesh/polygons.ts';
import type { FaceVaryingRule } from '../../../../scene/subdivide/faceVarying.ts';
import { distanceFromLimit } from '../../../../scene/subdivide/flatness.ts';
import {
  boundaryFaces,
  type SubdividedPolygons,
  subdividePolygons,
} from '../../../../scene/subdivide/subdividePolygons.ts';
import { makeTopology, type SubdivisionTopology } from '../../../../scene/subdivide/topology.ts';
import { DiagnosticList } from '../../../diagnostics/diagnosticLog.ts';
import { numbersAt, textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { reportSubdivision, SMOOTH_ROWS, schemeOf } from './subdivisionScheme.ts';

/** A control cage with the sharpness that its prim writes. */
export interface PrimCage {
  /** Valid. */
  readonly polygons: Polygons;
  readonly topology: SubdivisionTopology;
  /** By face, whether it shapes the surface without being drawn, because boundaries are not interpolated. */
  readonly open?: Uint8Array;
}

export function primCage(context: StageContext, prim: PrimSpec, polygons: Polygons): PrimCage {
  const points = polygons.points.length / 3;
  const creases = creasesOf(context, prim, points);
  const boundary = tokenChoice(context, prim, 'interpolateBoundary', BOUNDARIES, 'edgeAndCorner');
  const topology = makeTopology({
    points,
    faceCounts: polygons.faceCounts,
    faceIndices: polygons.faceIndices,
    sharpCorners: boundary === 'edgeAndCorner',
    pointSharpness: cornerSharpness(context, prim, points),
    ...(creases ? { creaseSharpness: creases } : {}),
  });
  const open = boundary === 'none' ? boundaryFaces(topology, creases ?? (() => 0)) : undefined;
  return { polygons, topology, ...(open && { open }) };
}

/** @param isHole by the face's index in the cage */
export function subdivideMesh(
  context: StageContext,
  prim: PrimSpec,
  { polygons, topology, open }: PrimCage,
  levels: number,
  isHole: (face: number) => boolean,
): SubdividedPolygons {
  return subdividePolygons(polygons, topology, {
    scheme: schemeOf(prim)!,
    levels,
    faceVarying: tokenChoice(context, prim, 'faceVaryingLinearInterpolation', FACE_VARYING, 'cornersPlus1'),
    smoothTriangles: textAt(prim, 'triangleSubdivisionRule', context.startCode) === 'smooth',
    hidden: (face) => isHole(face) || open?.[face] === 1,
  });
}

/**
 * Levels with which a mesh looks smooth; undefined if it is not a smooth surface, or has faults. `exact`: it is the limit
 * surface then, or nearly.
 */
export function levelsToLookSmooth(
  context: StageContext,
  prim: PrimSpec,
): { levels: number; exact: boolean } | undefined {
  const at = (name: string) => numbersAt(prim, name, context.startCode) ?? [];
  const [points, faceCounts, faceIndices] = [at('points'), at('faceVertexCounts'), at('faceVertexIndices')];
  if (schemeOf(prim) === 'bilinear' || !areFaces(faceCounts, faceIndices, points.length / 3)) return undefined;
  // Faults are reported when the mesh is made.
  const silent = { ...context, diagnostics: new DiagnosticList() };
  const { topology } = primCage(silent, prim, { points, faceCounts, faceIndices });
  const pixels = (SMOOTH_ROWS * distanceFromLimit(topology, points)) / extentOf(points, topology.corners);
  return { levels: pixels > 1 ? Math.ceil(Math.log2(pixels) / 2) : 0, exact: !(pixels > EXACT_PIXELS) };
}

/** Whether all faces have three corners or more, at points that exist, each at another than the one before. */
function areFaces(counts: ArrayLike<number>, indices: ArrayLike<number>, points: number): boolean {
  let first = 0;
  for (let face = 0; face < counts.length; face++) {
    const end = first + counts[face];
    if (!(counts[face] >= 3 && end <= indices.length)) return false;
    for (let c = first, before = indices[end - 1]; c < end; before = indices[c++])
      if (!(indices[c] >= 0 && indices[c] < points) || indices[c] === before) return false;
    first = end;
  }
  return first === indices.length;
}
const EXACT_PIXELS = 1e-3;

/** The longest side of the box about the points of some corners. */
function extentOf(points: ArrayLike<number>, corners: Uint32Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const p of corners)
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], points[3 * p + k]);
      high[k] = Math.max(high[k], points[3 * p + k]);
    }
  return Math.max(...high.map((x, k) => x - low[k]));
}

const BOUNDARIES = ['none', 'edgeOnly', 'edgeAndCorner'] as const;
const FACE_VARYING = [
  'none',
  'cornersOnly',
  'cornersPlus1',
  'cornersPlus2',
  'boundaries',
  'all',
] as const satisfies FaceVaryingRule[];

function tokenChoice<T extends string>(
  context: StageContext,
  prim: PrimSpec,
  name: string,
  options: readonly T[],
  fallback: T,
): T {
  const written = textAt(prim, name, context.startCode);
  const found = options.find((option) => option === written);
  if (written !== undefined && !found)
    reportSubdivision(
      context,
      prim,
      'warning',
      msg`${name} '${written}' is not ${listed(options)}; ${fallback} is taken`,
    );
  return found ?? fallback;
}

/** Sharpness by an edge's end points. Each crease is a chain of points with one sharpness, or one per edge. */
function creasesOf(
  context: StageContext,
  prim: PrimSpec,
  points: number,
): ((a: number, b: number) => number) | undefined {
  const at = (name: string) => numbersAt(prim, name, context.startCode) ?? [];
  const [indices, lengths, sharpness] = [at('creaseIndices'), at('creaseLengths'), at('creaseSharpnesses')];
  if (indices.length === 0) return undefined;
  const total = Array.from(lengths).reduce((sum, n) => sum + n, 0);
  const edges = total - lengths.length;
  const perEdge = sharpness.length === edges && sharpness.length !== lengths.length;
  const areRuns = total === indices.length && Array.from(lengths).every((n) => n >= 2);
  const fits = areRuns && (perEdge || sharpness.length === lengths.length);
  if (!fits || !Array.from(indices).every((p) => p >= 0 && p < points)) {
    const what = fits
      ? msg`creaseIndices names points that are not there`
      : msg`creaseLengths, creaseIndices and creaseSharpnesses do not fit each other`;
    reportSubdivision(context, prim, 'warning', msg`${what}; the creases are left out`);
    return undefined;
  }
  const byEdge = new Map<number, number>();
  const key = (a: number, b: number): number => Math.min(a, b) * points + Math.max(a, b);
  let [first, edge] = [0, 0];
  for (let run = 0; run < lengths.length; run++) {
    for (let i = first; i + 1 < first + lengths[run]; i++, edge++)
      byEdge.set(key(indices[i], indices[i + 1]), sharpness[perEdge ? edge : run]);
    first += lengths[run];
  }
  return (a, b) => byEdge.get(key(a, b)) ?? 0;
}

function cornerSharpness(context: StageContext, prim: PrimSpec, points: number): Float64Array {
  const at = (name: string) => numbersAt(prim, name, context.startCode) ?? [];
  const [indices, sharpness] = [at('cornerIndices'), at('cornerSharpnesses')];
  const out = new Float64Array(points);
  const fits = indices.length === sharpness.length && Array.from(indices).every((p) => p >= 0 && p < points);
  if (!fits)
    reportSubdivision(
      context,
      prim,
      'warning',
      msg`cornerIndices and cornerSharpnesses do not fit each other or the points; the corners are left out`,
    );
  else for (let i = 0; i < indices.length; i++) out[indices[i]] = sharpness[i];
  return out;
}
