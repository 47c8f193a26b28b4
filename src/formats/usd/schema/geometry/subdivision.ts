import { listed, msg } from '../../../../messages/message.ts';
import type { Polygons } from '../../../../scene/mesh/polygons.ts';
import type { FaceVaryingRule } from '../../../../scene/subdivide/faceVarying.ts';
import {
  boundaryFaces,
  type SubdividedPolygons,
  subdividePolygons,
} from '../../../../scene/subdivide/subdividePolygons.ts';
import { makeTopology } from '../../../../scene/subdivide/topology.ts';
import { numbersAt, textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { reportSubdivision, schemeOf } from './subdivisionLevels.ts';

/** @param cage the valid polygons; `isHole` by their index */
export function subdivideMesh(
  context: StageContext,
  prim: PrimSpec,
  cage: Polygons,
  levels: number,
  isHole: (face: number) => boolean,
): SubdividedPolygons {
  const points = cage.points.length / 3;
  const creases = creasesOf(context, prim, points);
  const boundary = tokenChoice(context, prim, 'interpolateBoundary', BOUNDARIES, 'edgeAndCorner');
  const topology = makeTopology({
    points,
    faceCounts: cage.faceCounts,
    faceIndices: cage.faceIndices,
    sharpCorners: boundary === 'edgeAndCorner',
    pointSharpness: cornerSharpness(context, prim, points),
    ...(creases ? { creaseSharpness: creases } : {}),
  });
  const open = boundary === 'none' ? boundaryFaces(topology, creases ?? (() => 0)) : undefined;
  return subdividePolygons(cage, topology, {
    scheme: schemeOf(prim)!,
    levels,
    faceVarying: tokenChoice(context, prim, 'faceVaryingLinearInterpolation', FACE_VARYING, 'cornersPlus1'),
    smoothTriangles: textAt(prim, 'triangleSubdivisionRule', context.startCode) === 'smooth',
    hidden: (face) => isHole(face) || open?.[face] === 1,
  });
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
