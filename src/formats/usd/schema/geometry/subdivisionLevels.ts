import { msg } from '../../../../messages/message.ts';
import { facesAfter } from '../../../../scene/subdivide/scheme.ts';
import { attributeOf, numbersAt, sampleTimes } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { isActive } from '../../layer/query.ts';
import { countOf } from '../../layer/storedArray.ts';
import type { MeshLevels, StageContext, SubdivisionLevels } from '../context.ts';
import { maybeSkinned } from '../skel/maybeSkinned.ts';
import { reportSubdivision, schemeOf, type UsdSubdivisionScheme } from './subdivisionScheme.ts';

/** Default levels: the first number, and up to the second until a mesh has enough faces to look round. */
const [MIN_LEVELS, MAX_LEVELS] = [2, 4];
const SMOOTH_FACES = 300;
/** Maximum number of faces of all subdivided meshes of a scene together, unless their cages have more. */
export const FACE_BUDGET = 500_000;
/** The same of all that is drawn, if no levels are requested: instances share a mesh, but not the work of drawing it. */
export const DRAWN_FACE_BUDGET = 1_000_000;

/**
 * Levels by path: as requested for each mesh, or by default as many as make it look round or smooth. If the scene would
 * exceed its face budgets, the largest meshes get fewer; `wanted` are the levels without them.
 */
async function subdivisionLevels(context: StageContext): Promise<SubdivisionLevels> {
  const requested = context.subdivision.wanted;
  const all = [...context.layer.rootPrims.values()].flatMap((prim) => subdividedMeshes(prim, false));
  const meshes = [...new Map(all.map((mesh) => [mesh.key, mesh])).values()];
  const wanted = new Map<string, WantedLevels>();
  for (const mesh of meshes)
    wanted.set(mesh.key, requested === undefined ? await automaticLevels(context, mesh) : { wanted: requested });
  const levels = new Map([...wanted].map(([key, of]) => [key, of.wanted]));
  const instances = new Map<string, number>();
  for (const { key } of all) instances.set(key, (instances.get(key) ?? 0) + 1);
  const faces = (mesh: SubdivisionCandidate): number => facesOf(mesh, levels.get(mesh.key)!);
  const drawn = (mesh: SubdivisionCandidate): number => instances.get(mesh.key)! * faces(mesh);
  reduceToBudget(meshes, levels, faces, FACE_BUDGET);
  if (requested === undefined) reduceToBudget(meshes, levels, drawn, DRAWN_FACE_BUDGET);
  return new Map(all.map(({ path, key }) => [path, { levels: levels.get(key)!, ...wanted.get(key)! }]));
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

type WantedLevels = Pick<MeshLevels, 'wanted' | 'fewer'>;

async function automaticLevels(context: StageContext, mesh: SubdivisionCandidate): Promise<WantedLevels> {
  let round = MIN_LEVELS;
  while (round < MAX_LEVELS && facesOf({ ...mesh, copies: 1 }, round) < SMOOTH_FACES) round++;
  if (!mesh.rests || mesh.corners > FACE_BUDGET) return { wanted: round };
  const { levelsToLookSmooth } = await import('./subdivision.ts');
  const smooth = levelsToLookSmooth(context, mesh.prim);
  if (!smooth || smooth.levels >= round) return { wanted: round };
  return { wanted: smooth.levels, ...(!smooth.exact && { fewer: true }) };
}

interface SubdivisionCandidate {
  readonly prim: PrimSpec;
  readonly path: string;
  /** Equal for prims with the same opinions. */
  readonly key: string;
  /** Most at any time. */
  readonly corners: number;
  /** How often they are sampled. */
  readonly copies: number;
  readonly scheme: UsdSubdivisionScheme;
  /** Whether its points stay where they are, so that what looks smooth always does. */
  readonly rests: boolean;
}

/** `skinned`: whether what is around the prim may be. */
function subdividedMeshes(prim: PrimSpec, skinned: boolean): SubdivisionCandidate[] {
  if (prim.specifier !== 'def' || !isActive(prim)) return [];
  const bends = maybeSkinned(prim, skinned);
  const scheme = prim.typeName === 'Mesh' ? schemeOf(prim) : undefined;
  const below = [...prim.children.values()].flatMap((child) => subdividedMeshes(child, bends));
  if (!scheme) return below;
  const { path, content: key = path } = prim;
  const rests = !bends && sampleTimes(attributeOf(prim, 'points')).length === 0;
  return [{ prim, path, key, ...cornersOf(prim), scheme, rests }, ...below];
}

function cornersOf(prim: PrimSpec): Pick<SubdivisionCandidate, 'corners' | 'copies'> {
  const indices = attributeOf(prim, 'faceVertexIndices');
  const samples = indices?.timeSamples?.values ?? [];
  const counts = (samples.length > 0 ? samples : [indices?.value]).map((value) => (value && countOf(value)) ?? 0);
  return { corners: counts.reduce((a, b) => Math.max(a, b), 0), copies: counts.length };
}

/** Subdivision levels of a mesh; undefined: drawn as polygons. */
export async function levelsOf(context: StageContext, prim: PrimSpec): Promise<number | undefined> {
  const scheme = schemeOf(prim);
  if (!scheme) return undefined;
  context.subdivision.levels ??= subdivisionLevels(context);
  const found = (await context.subdivision.levels).get(prim.path);
  const isRequested = context.subdivision.wanted !== undefined;
  if (!found || (isRequested && found.wanted === 0)) {
    if (context.subdivided.at(-1) !== prim.path) context.subdivided.push(prim.path);
    return undefined;
  }
  const { levels, wanted, fewer } = found;
  if (levels < wanted)
    reportSubdivision(
      context,
      prim,
      'info',
      msg`it is subdivided ${levels} times, not ${wanted}: a scene's surfaces share ${FACE_BUDGET.toLocaleString('en')} faces, instances counted ${DRAWN_FACE_BUDGET.toLocaleString('en')}`,
    );
  if (levels === 0 && wanted > 0) return undefined;
  if (scheme === 'loop' && !(numbersAt(prim, 'faceVertexCounts', context.startCode) ?? []).every((n) => n === 3)) {
    const message = msg`subdivisionScheme loop takes triangles only; it is drawn as its polygons`;
    reportSubdivision(context, prim, 'warning', message);
    return undefined;
  }
  if (fewer) context.smooth.set(prim.path, levels);
  return levels;
}
