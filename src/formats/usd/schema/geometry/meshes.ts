import { anyOf, msg } from '../../../../messages/message.ts';
import { gatherPoints, makeMesh } from '../../../../scene/mesh/makeMesh.ts';
import type { Polygons, PolygonValues } from '../../../../scene/mesh/polygons.ts';
import { withoutQuadric } from '../../../../scene/mesh/quadric.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, lowerSample, numbersAt, sampleTimes, textAt } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import { countOf, storedSamples } from '../../layer/storedArray.ts';
import { isTrue, type StageContext } from '../context.ts';
import type { MeshPiece } from '../lives/meshPieces.ts';
import type { PrimMaterials } from '../materials/materialBinding.ts';
import { deformedMesh } from '../placement/deforming.ts';
import { type MeshElementCounts, type Primvar, primvarOf, valuesOnMesh } from '../primvars.ts';
import type { Skin, Skins, VertexOrigins } from '../skel/skin.ts';
import { pointBytes, vectorsPerVertex } from './pointSampling.ts';
import type { DeformedPoints, PrimGeometry, StoredDeformation } from './primGeometry.ts';
import { levelsOf } from './subdivisionLevels.ts';

interface FaceArrays {
  readonly points: NumberArray;
  readonly counts: NumberArray;
  readonly indices: NumberArray;
}

/** The drawable faces, with the original indices of faces and corners, by which primvars are looked up. */
interface KeptFaces {
  readonly counts: number[];
  readonly points: number[];
  readonly faces: number[];
  readonly corners: number[];
  /** Holes among these faces; they are not drawn. */
  readonly holes: Set<number>;
}

/** Angle between faces below which shading is smooth if a subdivision surface is drawn as polygons. */
const SMOOTH_ANGLE = Math.PI / 3;

/** Number of points of a skinned mesh whose paths between samples are probed. */
const PROBE_POINTS = 64;
/** Number of skinned points that cost as much as one transform. */
const POINTS_PER_TRANSFORM = 8;

/**
 * A Mesh prim as triangles with its deformation; undefined, with a diagnostic, if it has no valid faces. `skins`: of the stage, if it may be skinned. `piece`: one
 * of the meshes that it is, if its topology changes; `context` is then that of its time.
 */
export async function meshGeometry(
  context: StageContext,
  skins: Skins | undefined,
  prim: PrimSpec,
  surface: PrimMaterials,
  piece?: MeshPiece,
): Promise<PrimGeometry | undefined> {
  const faces = facesOf(context, prim);
  if (!faces) return undefined;
  const topology = { points: faces.points.length / 3, corners: faces.indices.length, faces: faces.counts.length };
  const wanted = await levelsOf(context, prim);
  const levels = wanted !== undefined && !piece && staysInFile(context, prim, topology.points) ? undefined : wanted;
  const kept = keptFaces(context, prim, faces, levels !== undefined);
  const uvs = surface.uvs(prim, topology);
  const colors = surface.colors(prim, topology);
  const materials = surface.faceMaterials(topology.faces);
  const polygons: Polygons = {
    points: faces.points,
    faceCounts: kept?.counts ?? faces.counts,
    faceIndices: kept?.points ?? faces.indices,
    ...(uvs ? { uvs: valuesOnKept(uvs, kept) } : {}),
    ...(colors ? { colors: valuesOnKept(colors, kept) } : {}),
    faceMaterials: kept ? kept.faces.map((f) => materials[f]) : materials,
    leftHanded: textAt(prim, 'orientation', context.startCode) === 'leftHanded',
    doubleSided: isTrue(context, prim, 'doubleSided'),
  };
  const moved = piece ? piece.codes : pointTimes(context, prim);
  const skin = piece ? undefined : skins?.skinOf(prim, { count: topology.points, times: moved });
  const drawn =
    levels === undefined
      ? plainMesh(context, prim, polygons, topology, kept, { skin, times: piece?.codes })
      : await subdividedMesh(context, prim, polygons, levels, kept);
  if (!piece) return withDeformation(context, prim, moved, drawn, skin);
  const { pieceGeometry } = await import('../lives/pieceGeometry.ts');
  return pieceGeometry(context, prim, drawn.mesh, piece, drawn.pointsFor);
}

/** Whether the samples of the points exceed memory and can stay in the file; reported, because such a mesh cannot be subdivided. */
function staysInFile(context: StageContext, prim: PrimSpec, points: number): boolean {
  const attribute = attributeOf(prim, 'points');
  const bytes = pointBytes(sampleTimes(attribute).length, points, vectorsPerVertex(context));
  if (bytes <= context.sampleMemory.bytes || !storedSamples(attribute)) return false;
  const message = msg`its samples are too many to be subdivided and stay in their file; it is drawn as its polygons`;
  report(context, 'info', 'usd.subdivision', prim.path, message);
  return true;
}

/** A mesh and the functions that map the prim's points at another time to its vertices. */
interface PolygonMesh {
  readonly mesh: Mesh;
  pointsFor(points: ArrayLike<number>, time: number): DeformedPoints;
  /** Present if vertices are points of the prim. */
  readonly vertices?: VertexOrigins;
  /** Present if vertices, and sampled normals, can be read directly from the file. */
  readonly stored?: Omit<StoredDeformation, 'points'>;
}

function plainMesh(
  context: StageContext,
  prim: PrimSpec,
  polygons: Polygons,
  topology: MeshElementCounts,
  kept: KeptFaces | undefined,
  { skin, times }: { readonly skin: Skin | undefined; readonly times: Float64Array | undefined },
): PolygonMesh {
  const authored = normalsOf(context, prim, topology);
  const smoothAngle = textAt(prim, 'subdivisionScheme', undefined) === 'none' ? 0 : SMOOTH_ANGLE;
  const { mesh, pointOfVertex } = makeMesh({
    ...polygons,
    ...(authored ? { normals: valuesOnKept(authored.values, kept) } : { smoothAngle }),
  });
  const sampled =
    authored && areSampledNormals(authored.primvar, topology.points, times)
      ? authored.primvar.attribute.name
      : undefined;
  const normals = sampled === undefined ? undefined : storedSamples(attributeOf(prim, sampled));
  const normalsAt = (time: number): Float32Array | undefined => {
    if (skin) return authored && skin.normalsAt(time, mesh.normals, pointOfVertex);
    return sampled === undefined ? undefined : gatherPoints(numbersAt(prim, sampled, time)!, pointOfVertex);
  };
  return {
    mesh,
    vertices: { pointOfVertex, areNormalsAuthored: authored !== undefined },
    ...(sampled === undefined || normals ? { stored: { pointOfVertex, normals } } : {}),
    pointsFor: (points, time) => {
      const normals = normalsAt(time);
      return { positions: gatherPoints(points, pointOfVertex), ...(normals ? { normals } : {}) };
    },
  };
}

/** Whether normals are sampled per point, with the same count at every time, or at the given sample times. */
function areSampledNormals({ interpolation, indices, attribute }: Primvar, points: number, at?: Float64Array): boolean {
  if (interpolation !== 'point' || indices || sampleTimes(attribute).length === 0) return false;
  const { times, values } = attribute.timeSamples!;
  const needed = at ? Array.from(at, (time) => values[lowerSample(times, time)]) : values;
  return needed.every((value) => countOf(value) === 3 * points);
}

async function subdividedMesh(
  context: StageContext,
  prim: PrimSpec,
  cage: Polygons,
  levels: number,
  kept: KeptFaces | undefined,
): Promise<PolygonMesh> {
  const { primCage, subdivideMesh } = await import('./subdivision.ts');
  const isHole = (face: number): boolean => kept?.holes.has(face) ?? false;
  const { polygons, surface } = subdivideMesh(context, prim, primCage(context, prim, cage), levels, isHole);
  const { mesh, pointOfVertex } = makeMesh(polygons);
  return {
    mesh,
    pointsFor: (points) => {
      const { positions, normals } = surface.at(points);
      if (cage.leftHanded) for (let i = 0; i < normals.length; i++) normals[i] = -normals[i];
      return { positions: gatherPoints(positions, pointOfVertex), normals: gatherPoints(normals, pointOfVertex) };
    },
  };
}

/** The mesh with its deformation: by its skin, else by samples of its points. */
function withDeformation(
  context: StageContext,
  prim: PrimSpec,
  times: Float64Array,
  drawn: PolygonMesh,
  skin: Skin | undefined,
): PrimGeometry {
  const { mesh } = drawn;
  if (!skin) {
    if (times.length === 0) return { mesh };
    const at = (time: number): DeformedPoints => drawn.pointsFor(numbersAt(prim, 'points', time)!, time);
    const points = drawn.stored && storedSamples(attributeOf(prim, 'points'));
    const stored = drawn.stored && points ? { stored: { ...drawn.stored, points } } : {};
    const count = numbersAt(prim, 'points', context.startCode)!.length;
    if (!context.cubic || !velocitiesOf(context, prim, times, count))
      return { mesh, deformation: { times, at, ...stored } };
    // Vertices are linear in the points, so velocities are mapped the same way.
    const velocitiesAt = (time: number) => drawn.pointsFor(numbersAt(prim, 'velocities', time)!, time).positions;
    return { mesh, deformation: { times, at, velocitiesAt, ...stored } };
  }
  const transform = skin.transform ? { transform: skin.transform } : {};
  if (skin.isRigid) return { mesh, ...transform };
  const at = (time: number): DeformedPoints => drawn.pointsFor(skin.pointsAt(time), time);
  if (skin.times.length === 0) return { mesh: deformedMesh(mesh, at(context.startCode)), ...transform };
  const blend = drawn.vertices && !context.cubic ? skin.blendOf(mesh, drawn.vertices) : undefined;
  if (blend) return { mesh: withoutQuadric(mesh), deformation: { times: skin.times, at, blend }, ...transform };
  const points = numbersAt(prim, 'points', context.startCode)!.length / 3;
  const some = Uint32Array.from({ length: Math.min(PROBE_POINTS, points) }, (_, i) =>
    Math.floor((i * points) / Math.min(PROBE_POINTS, points)),
  );
  const cost = skin.cost + some.length / POINTS_PER_TRANSFORM;
  const follow = { cost, pointsAt: (time: number) => skin.pointsAt(time, some) };
  return {
    mesh: deformedMesh(mesh, at(context.startCode)),
    deformation: { times: skin.times, at, probe: follow },
    ...transform,
  };
}

function facesOf(context: StageContext, prim: PrimSpec): FaceArrays | undefined {
  const at = (name: string) => numbersAt(prim, name, context.startCode);
  const [points, counts, indices] = [at('points'), at('faceVertexCounts'), at('faceVertexIndices')];
  if (!points || !counts || !indices) {
    const arrays = { points, faceVertexCounts: counts, faceVertexIndices: indices };
    const missing = Object.entries(arrays).flatMap(([name, values]) => (values ? [] : [name]));
    const message = msg`the mesh has no ${anyOf(missing)}; it is left out`;
    report(context, 'warning', 'usd.empty-mesh', prim.path, message);
    return undefined;
  }
  return { points, counts, indices };
}

/**
 * Undefined if every face can be drawn. Invalid faces are omitted with a warning; holes too, unless they shape a
 * subdivision surface.
 */
function keptFaces(
  context: StageContext,
  prim: PrimSpec,
  { points, counts, indices }: FaceArrays,
  keepsHoles: boolean,
): KeptFaces | undefined {
  const holes = new Set(numbersAt(prim, 'holeIndices', undefined));
  const starts = new Int32Array(counts.length);
  let [first, bad, left] = [0, 0, 0];
  for (let face = 0; face < counts.length; face++) {
    const count = Math.max(0, counts[face]);
    const fits = count >= 3 && first + count <= indices.length && pointsExist(indices, first, count, points.length / 3);
    if (!fits) bad++;
    const isKept = fits && (keepsHoles || !holes.has(face));
    if (!isKept || (keepsHoles && (holes.has(face) || repeatsPoint(indices, first, count)))) left++;
    starts[face] = isKept ? first : -1;
    first += count;
  }
  if (bad > 0) {
    const message = msg`${bad} of ${counts.length} faces have fewer than 3 corners or name points that are not there; they are left out`;
    report(context, 'warning', 'usd.faces', prim.path, message);
  }
  if (left === 0) return undefined;
  const kept: KeptFaces = { counts: [], points: [], faces: [], corners: [], holes: new Set() };
  starts.forEach((start, face) => {
    if (start < 0) return;
    const isAdded = keepFace(kept, indices, face, start, counts[face], keepsHoles);
    if (isAdded && holes.has(face)) kept.holes.add(kept.faces.length - 1);
  });
  return kept;
}

/** Whether a corner repeats the point of the previous one: an edge of zero length. */
function repeatsPoint(indices: NumberArray, first: number, count: number): boolean {
  for (let c = 0; c < count; c++) if (indices[first + c] === indices[first + ((c + 1) % count)]) return true;
  return false;
}

function pointsExist(indices: NumberArray, first: number, count: number, points: number): boolean {
  for (let c = first; c < first + count; c++) if (!(indices[c] >= 0 && indices[c] < points)) return false;
  return true;
}

/** `once`: corners that repeat the previous point are omitted, and faces with fewer than three remaining corners. */
function keepFace(
  kept: KeptFaces,
  indices: NumberArray,
  face: number,
  first: number,
  count: number,
  once: boolean,
): boolean {
  const corners: number[] = [];
  for (let c = first; c < first + count; c++) {
    const next = c + 1 < first + count ? c + 1 : first;
    if (!once || indices[c] !== indices[next]) corners.push(c);
  }
  if (corners.length < 3) return false;
  kept.faces.push(face);
  kept.counts.push(corners.length);
  for (const c of corners) {
    kept.corners.push(c);
    kept.points.push(indices[c]);
  }
  return true;
}

function valuesOnKept(values: PolygonValues, kept: KeptFaces | undefined): PolygonValues {
  if (!kept || values.per === 'point' || values.per === 'constant') return values;
  const places = values.per === 'corner' ? kept.corners : kept.faces;
  return { ...values, indices: values.indices ? places.map((p) => values.indices![p]) : places };
}

interface MeshNormals {
  readonly primvar: Primvar;
  readonly values: PolygonValues;
}

/** `primvars:normals` takes precedence over `normals`. */
function normalsOf(context: StageContext, prim: PrimSpec, topology: MeshElementCounts): MeshNormals | undefined {
  for (const name of ['primvars:normals', 'normals']) {
    const primvar = primvarOf(prim, name, context.startCode, 'vertex');
    const values = primvar && valuesOnMesh(context, prim, name, primvar, 3, topology);
    if (values) return { primvar, values };
  }
  return undefined;
}

/** Time codes of the points' samples; none if their number changes, as it may only of skinned meshes, whose shape is then held. */
function pointTimes(context: StageContext, prim: PrimSpec): Float64Array {
  const points = attributeOf(prim, 'points');
  const times = sampleTimes(points);
  const count = numbersAt(prim, 'points', context.startCode)!.length;
  const isConstant = times.length === 0 || points!.timeSamples!.values.every((value) => countOf(value) === count);
  return isConstant ? times : new Float64Array(0);
}

/** Whether the file has a velocity for each point at each of the points' samples. */
function velocitiesOf(context: StageContext, prim: PrimSpec, times: Float64Array, count: number): boolean {
  const samples = attributeOf(prim, 'velocities')?.timeSamples;
  if (!samples) return false;
  const areAligned = samples.times.length === times.length && samples.times.every((t, k) => t === times[k]);
  if (areAligned && samples.values.every((value) => countOf(value) === count)) return true;
  const message = msg`its velocities are not given for each of ${count / 3} points at each of ${times.length} samples; they are taken from the points`;
  report(context, 'info', 'usd.velocities', prim.path, message);
  return false;
}
