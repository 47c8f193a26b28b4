import { type Message, msg } from '../../../../messages/message.ts';
import { facesAfter, type SubdivisionScheme } from '../../../../scene/subdivide/scheme.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, textAt } from '../../layer/attributes.ts';
import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { isActive } from '../../layer/query.ts';
import { countOf } from '../../layer/storedArray.ts';
import type { AffordableLevels, StageContext, SubdivisionLevels } from '../context.ts';

/** Default levels: the first number, and up to the second until a mesh has enough faces to look round. */
const [MIN_LEVELS, MAX_LEVELS] = [2, 4];
const SMOOTH_FACES = 300;
/** Maximum number of faces of all subdivided meshes of a scene together, unless their cages have more. */
export const FACE_BUDGET = 500_000;
/** The same of all that is drawn, if no levels are requested: instances share a mesh, but not the work of drawing it. */
export const DRAWN_FACE_BUDGET = 1_000_000;

/** Rows of a picture that a mesh may fill without being more than about a pixel from its limit surface, if no levels are requested. */
export const SMOOTH_ROWS = 1080;

export type UsdSubdivisionScheme = Exclude<SubdivisionScheme, 'linear'>;
const SCHEMES: readonly string[] = ['catmullClark', 'loop', 'bilinear'] satisfies UsdSubdivisionScheme[];

/** Undefined for polygonal meshes. Unknown schemes are Catmull–Clark, the default. */
export function schemeOf(prim: PrimSpec): UsdSubdivisionScheme | undefined {
  const written = textAt(prim, 'subdivisionScheme', undefined) ?? 'catmullClark';
  if (written === 'none') return undefined;
  return SCHEMES.includes(written) ? (written as UsdSubdivisionScheme) : 'catmullClark';
}

/**
 * Levels by path: `requested` for each mesh, or by default as many as make it look round. If the scene would exceed its face
 * budgets, the largest meshes get fewer; `wanted` are the levels without them.
 */
export function subdivisionLevels(layer: Layer, requested?: number): SubdivisionLevels {
  const all = [...layer.rootPrims.values()].flatMap((prim) => subdividedMeshes(prim));
  const meshes = [...new Map(all.map((mesh) => [mesh.key, mesh])).values()];
  const levels = new Map(meshes.map((mesh) => [mesh.key, requested ?? automaticLevels(mesh)]));
  const instances = new Map<string, number>();
  for (const { key } of all) instances.set(key, (instances.get(key) ?? 0) + 1);
  const faces = (mesh: SubdivisionCandidate): number => facesOf(mesh, levels.get(mesh.key)!);
  const drawn = (mesh: SubdivisionCandidate): number => instances.get(mesh.key)! * faces(mesh);
  reduceToBudget(meshes, levels, faces, FACE_BUDGET);
  if (requested === undefined) reduceToBudget(meshes, levels, drawn, DRAWN_FACE_BUDGET);
  return new Map(
    all.map((mesh) => [mesh.path, { levels: levels.get(mesh.key)!, wanted: requested ?? automaticLevels(mesh) }]),
  );
}

/** Takes levels away until `faces` of all meshes are within the budget. */
function reduceToBudget(
  meshes: readonly SubdivisionCandidate[],
  levels: Map<string, number>,
  faces: (mesh: SubdivisionCandidate) => number,
  budget: number,
): void {
  let total = meshes.reduce((sum, mesh) => sum + faces(mesh), 0);
  while (total > budget && meshes.some(({ key }) => levels.get(key)! > 0)) {
    // One level less means a quarter of the faces: reduce the largest meshes first.
    const largestFirst = meshes.filter(({ key }) => levels.get(key)! > 0).sort((a, b) => faces(b) - faces(a));
    for (const mesh of largestFirst) {
      if (total <= budget) break;
      total -= faces(mesh);
      levels.set(mesh.key, levels.get(mesh.key)! - 1);
      total += faces(mesh);
    }
  }
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

/** Subdivision levels of a mesh within the budget, and those that it is worth; 0: drawn as polygons. */
export function levelsOf(context: StageContext, prim: PrimSpec): AffordableLevels {
  const scheme = schemeOf(prim);
  if (!scheme) return { levels: 0, wanted: 0 };
  context.subdivision.levels ??= subdivisionLevels(context.layer, context.subdivision.wanted);
  const found = context.subdivision.levels.get(prim.path) ?? { levels: 0, wanted: 0 };
  if (found.wanted === 0 && context.subdivided.at(-1) !== prim.path) context.subdivided.push(prim.path);
  if (found.levels === 0) reportFewer(context, prim, found);
  if (found.levels === 0 || scheme !== 'loop') return found;
  const counts = numbersAt(prim, 'faceVertexCounts', context.startCode) ?? [];
  if (counts.every((count) => count === 3)) return found;
  reportSubdivision(
    context,
    prim,
    'warning',
    msg`subdivisionScheme loop takes triangles only; it is drawn as its polygons`,
  );
  return { levels: 0, wanted: 0 };
}

/** Tells of a mesh that has fewer levels than it is worth. */
export function reportFewer(context: StageContext, prim: PrimSpec, { levels, wanted }: AffordableLevels): void {
  if (levels >= wanted) return;
  const message = msg`it is subdivided ${levels} times, not ${wanted}: a scene's surfaces share ${FACE_BUDGET.toLocaleString('en')} faces, instances counted ${DRAWN_FACE_BUDGET.toLocaleString('en')}`;
  reportSubdivision(context, prim, 'info', message);
}

export const reportSubdivision = (
  context: StageContext,
  prim: PrimSpec,
  severity: 'info' | 'warning',
  message: Message,
): void => report(context, severity, 'usd.subdivision', prim.path, message);
