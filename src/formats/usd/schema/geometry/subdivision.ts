import { listed, type Message, msg } from '../../../../messages/message.ts';
import type { Polygons } from '../../../../scene/mesh/polygons.ts';
import type { FaceVaryingRule } from '../../../../scene/subdivide/faceVarying.ts';
import { facesAfter } from '../../../../scene/subdivide/limitSurface.ts';
import {
  boundaryFaces,
  type SubdividedPolygons,
  type SubdivisionOptions,
  subdividePolygons,
} from '../../../../scene/subdivide/subdividePolygons.ts';
import { makeTopology } from '../../../../scene/subdivide/topology.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, textAt } from '../../layer/attributes.ts';
import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { isActive } from '../../layer/query.ts';
import { countOf } from '../../layer/storedArray.ts';
import type { StageContext, SubdivisionLevels } from '../context.ts';

/** Default levels: the first number, and up to the second until a mesh has enough faces to look round. */
const [MIN_LEVELS, MAX_LEVELS] = [2, 4];
const SMOOTH_FACES = 300;
/** Maximum number of faces of all subdivided meshes of a scene together, unless their cages have more. */
export const FACE_BUDGET = 500_000;

type UsdSubdivisionScheme = SubdivisionOptions['scheme'];
const SCHEMES: readonly string[] = ['catmullClark', 'loop', 'bilinear'] satisfies UsdSubdivisionScheme[];

/** Undefined for polygonal meshes. Unknown schemes are Catmull–Clark, the default. */
function schemeOf(prim: PrimSpec): UsdSubdivisionScheme | undefined {
  const written = textAt(prim, 'subdivisionScheme', undefined) ?? 'catmullClark';
  if (written === 'none') return undefined;
  return SCHEMES.includes(written) ? (written as UsdSubdivisionScheme) : 'catmullClark';
}

/**
 * Levels by path: `requested` for each mesh, or by default as many as make it look round. If the scene would exceed its face
 * budget, the largest meshes get fewer; `wanted` are the levels without the budget.
 */
export function subdivisionLevels(layer: Layer, requested?: number): SubdivisionLevels {
  const all = [...layer.rootPrims.values()].flatMap((prim) => subdividedMeshes(prim));
  // Instances share a mesh, counted once.
  const meshes = [...new Map(all.map((mesh) => [mesh.key, mesh])).values()];
  const levels = new Map(meshes.map((mesh) => [mesh.key, requested ?? automaticLevels(mesh)]));
  const faces = (mesh: SubdivisionCandidate): number => facesOf(mesh, levels.get(mesh.key)!);
  let total = meshes.reduce((sum, mesh) => sum + faces(mesh), 0);
  while (total > FACE_BUDGET && meshes.some(({ key }) => levels.get(key)! > 0)) {
    // One level less means a quarter of the faces: reduce the largest meshes first.
    const largestFirst = meshes.filter(({ key }) => levels.get(key)! > 0).sort((a, b) => faces(b) - faces(a));
    for (const mesh of largestFirst) {
      if (total <= FACE_BUDGET) break;
      total -= faces(mesh);
      levels.set(mesh.key, levels.get(mesh.key)! - 1);
      total += faces(mesh);
    }
  }
  return new Map(
    all.map((mesh) => [mesh.path, { levels: levels.get(mesh.key)!, wanted: requested ?? automaticLevels(mesh) }]),
  );
}

const facesOf = ({ corners, scheme, copies }: SubdivisionCandidate, levels: number): number =>
  levels === 0 ? 0 : copies * facesAfter(corners, scheme, levels);

function automaticLevels(mesh: SubdivisionCandidate): number {
  let levels = MIN_LEVELS;
  while (levels < MAX_LEVELS && facesOf({ ...mesh, copies: 1 }, levels) < SMOOTH_FACES) levels++;
  return levels;
}

interface SubdivisionCandidate {
  readonly path: string;
  /** Equal for prims with the same opinions. */
  readonly key: string;
  /** Most at any time. */
  readonly corners: number;
  /** How often they are sampled. */
  readonly copies: number;
  readonly scheme: UsdSubdivisionScheme;
}

function subdividedMeshes(prim: PrimSpec): SubdivisionCandidate[] {
  if (prim.specifier !== 'def' || !isActive(prim)) return [];
  const scheme = prim.typeName === 'Mesh' ? schemeOf(prim) : undefined;
  const below = [...prim.children.values()].flatMap((child) => subdividedMeshes(child));
  return scheme ? [{ path: prim.path, key: prim.content ?? prim.path, ...cornersOf(prim), scheme }, ...below] : below;
}

function cornersOf(prim: PrimSpec): Pick<SubdivisionCandidate, 'corners' | 'copies'> {
  const indices = attributeOf(prim, 'faceVertexIndices');
  const samples = indices?.timeSamples?.values ?? [];
  const counts = (samples.length > 0 ? samples : [indices?.value]).map((value) => (value && countOf(value)) ?? 0);
  return { corners: counts.reduce((a, b) => Math.max(a, b), 0), copies: counts.length };
}

/** Subdivision levels of a mesh; 0: drawn as polygons. */
export function levelsOf(context: StageContext, prim: PrimSpec): number {
  const scheme = schemeOf(prim);
  if (!scheme) return 0;
  context.subdivision.levels ??= subdivisionLevels(context.layer, context.subdivision.wanted);
  const { levels, wanted } = context.subdivision.levels.get(prim.path) ?? { levels: 0, wanted: 0 };
  if (levels < wanted)
    reportSubdivision(
      context,
      prim,
      'info',
      msg`it is subdivided ${levels} times, not ${wanted}: a scene's surfaces share ${FACE_BUDGET.toLocaleString('en')} faces`,
    );
  if (wanted === 0 && context.subdivided.at(-1) !== prim.path) context.subdivided.push(prim.path);
  if (levels === 0 || scheme !== 'loop') return levels;
  const counts = numbersAt(prim, 'faceVertexCounts', context.startCode) ?? [];
  if (counts.every((count) => count === 3)) return levels;
  reportSubdivision(
    context,
    prim,
    'warning',
    msg`subdivisionScheme loop takes triangles only; it is drawn as its polygons`,
  );
  return 0;
}

const reportSubdivision = (
  context: StageContext,
  prim: PrimSpec,
  severity: 'info' | 'warning',
  message: Message,
): void => report(context, severity, 'usd.subdivision', prim.path, message);

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
