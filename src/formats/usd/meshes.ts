import { gatherPoints, makeMesh } from '../../scene/geometry.ts';
import type { PolygonValues } from '../../scene/polygons.ts';
import { attributeOf, numbersAt, numbersOf, sampleTimes, textAt } from './attributes.ts';
import { isTrue, report, type StageContext } from './context.ts';
import type { NumberArray, PrimSpec } from './layer.ts';
import type { Deformation, Shape } from './placement.ts';
import { type Primvar, primvarOf, type Topology, valuesOnMesh } from './primvars.ts';
import type { Surface } from './surface.ts';

interface Faces {
  readonly points: NumberArray;
  readonly counts: NumberArray;
  readonly indices: NumberArray;
}

/** The faces that can be drawn, and the places of them and their corners among all: values are found by these. */
interface Kept {
  readonly counts: number[];
  readonly points: number[];
  readonly faces: number[];
  readonly corners: number[];
}

/** Faces that meet at less than this angle are shaded smooth where a subdivision surface is drawn as its polygons. */
const SMOOTH_ANGLE = Math.PI / 3;

/** A Mesh prim as triangles; undefined, with a diagnostic, where it has none. */
export function meshShape(context: StageContext, prim: PrimSpec, surface: Surface): Shape | undefined {
  const faces = facesOf(context, prim);
  if (!faces) return undefined;
  const topology = { points: faces.points.length / 3, corners: faces.indices.length, faces: faces.counts.length };
  const kept = keptFaces(context, prim, faces);
  const normals = normalsOf(context, prim, topology);
  const uvs = surface.uvs(prim, topology);
  const colors = surface.colors(prim, topology);
  const materials = surface.faceMaterials(topology.faces);
  const { mesh, pointOfVertex } = makeMesh({
    points: faces.points,
    faceCounts: kept?.counts ?? faces.counts,
    faceIndices: kept?.points ?? faces.indices,
    ...(normals ? { normals: onKept(normals.values, kept) } : { smoothAngle: smoothAngleOf(context, prim) }),
    ...(uvs ? { uvs: onKept(uvs, kept) } : {}),
    ...(colors ? { colors: onKept(colors, kept) } : {}),
    faceMaterials: kept ? kept.faces.map((f) => materials[f]) : materials,
    leftHanded: textAt(prim, 'orientation', context.startCode) === 'leftHanded',
    doubleSided: isTrue(context, prim, 'doubleSided'),
  });
  const deformation = deformationOf(context, prim, pointOfVertex, normals?.primvar);
  return { mesh, ...(deformation ? { deformation } : {}) };
}

function facesOf(context: StageContext, prim: PrimSpec): Faces | undefined {
  const at = (name: string) => numbersAt(prim, name, context.startCode);
  const [points, counts, indices] = [at('points'), at('faceVertexCounts'), at('faceVertexIndices')];
  if (!points || !counts || !indices) {
    const missing = [!points && 'points', !counts && 'faceVertexCounts', !indices && 'faceVertexIndices'];
    const message = `the mesh has no ${missing.filter(Boolean).join(', no ')}; it is left out`;
    report(context, 'warning', 'usd.empty-mesh', prim.path, message);
    return undefined;
  }
  for (const name of ['faceVertexCounts', 'faceVertexIndices'])
    if (sampleTimes(attributeOf(prim, name)).length > 0)
      report(context, 'warning', 'usd.topology', prim.path, `${name} changes with time; it is held at the start`);
  return { points, counts, indices };
}

/** Undefined where every face can be drawn. Holes, and faces that cannot be, are left out; the latter with a warning. */
function keptFaces(context: StageContext, prim: PrimSpec, { points, counts, indices }: Faces): Kept | undefined {
  const holes = new Set(numbersAt(prim, 'holeIndices', undefined));
  const starts = new Int32Array(counts.length);
  let [first, bad, left] = [0, 0, 0];
  for (let face = 0; face < counts.length; face++) {
    const count = Math.max(0, counts[face]);
    const fits = count >= 3 && first + count <= indices.length && pointsExist(indices, first, count, points.length / 3);
    if (!fits) bad++;
    if (!fits || holes.has(face)) left++;
    starts[face] = fits && !holes.has(face) ? first : -1;
    first += count;
  }
  if (bad > 0) {
    const message = `${bad} of ${counts.length} faces have fewer than 3 corners or name points that are not there; they are left out`;
    report(context, 'warning', 'usd.faces', prim.path, message);
  }
  if (left === 0) return undefined;
  const kept: Kept = { counts: [], points: [], faces: [], corners: [] };
  starts.forEach((start, face) => {
    if (start >= 0) keepFace(kept, indices, face, start, counts[face]);
  });
  return kept;
}

function pointsExist(indices: NumberArray, first: number, count: number, points: number): boolean {
  for (let c = first; c < first + count; c++) if (!(indices[c] >= 0 && indices[c] < points)) return false;
  return true;
}

function keepFace(kept: Kept, indices: NumberArray, face: number, first: number, count: number): void {
  kept.faces.push(face);
  kept.counts.push(count);
  for (let c = first; c < first + count; c++) {
    kept.corners.push(c);
    kept.points.push(indices[c]);
  }
}

function onKept(values: PolygonValues, kept: Kept | undefined): PolygonValues {
  if (!kept || values.per === 'point' || values.per === 'constant') return values;
  const places = values.per === 'corner' ? kept.corners : kept.faces;
  return { ...values, indices: values.indices ? places.map((p) => values.indices![p]) : places };
}

interface Normals {
  readonly primvar: Primvar;
  readonly values: PolygonValues;
}

/** `primvars:normals` before `normals`. */
function normalsOf(context: StageContext, prim: PrimSpec, topology: Topology): Normals | undefined {
  for (const name of ['primvars:normals', 'normals']) {
    const primvar = primvarOf(prim, name, context.startCode, 'vertex');
    const values = primvar && valuesOnMesh(context, prim, name, primvar, 3, topology);
    if (values) return { primvar, values };
  }
  return undefined;
}

function smoothAngleOf(context: StageContext, prim: PrimSpec): number {
  const scheme = textAt(prim, 'subdivisionScheme', undefined) ?? 'catmullClark';
  if (scheme === 'none') return 0;
  context.subdivided.push(prim.path);
  return SMOOTH_ANGLE;
}

function deformationOf(
  context: StageContext,
  prim: PrimSpec,
  pointOfVertex: Uint32Array,
  normals: Primvar | undefined,
): Deformation | undefined {
  const points = attributeOf(prim, 'points');
  const times = sampleTimes(points);
  if (times.length === 0) return undefined;
  const count = numbersAt(prim, 'points', context.startCode)!.length;
  if (points!.timeSamples!.values.some((value) => numbersOf(value)?.length !== count)) {
    const message = 'the number of points changes with time; the shape is held at the start';
    report(context, 'warning', 'usd.topology', prim.path, message);
    return undefined;
  }
  const velocities = context.cubic ? velocitiesOf(context, prim, times, count) : undefined;
  const gather = (name: string) => (time: number) => gatherPoints(numbersAt(prim, name, time)!, pointOfVertex);
  const given = normals?.interpolation === 'point' && !normals.indices && sampleTimes(normals.attribute).length > 0;
  const steady = given && normals.attribute.timeSamples!.values.every((v) => numbersOf(v)?.length === count);
  return {
    times,
    positionsAt: gather('points'),
    ...(velocities ? { velocitiesAt: gather('velocities') } : {}),
    ...(steady ? { normalsAt: gather(normals.attribute.name) } : {}),
  };
}

/** Whether the file gives a velocity for each point at each of the points' samples. */
function velocitiesOf(context: StageContext, prim: PrimSpec, times: Float64Array, count: number): boolean {
  const samples = attributeOf(prim, 'velocities')?.timeSamples;
  if (!samples) return false;
  const given = samples.times.length === times.length && samples.times.every((t, k) => t === times[k]);
  if (given && samples.values.every((value) => numbersOf(value)?.length === count)) return true;
  const message = `its velocities are not given for each of ${count / 3} points at each of ${times.length} samples; they are taken from the points`;
  report(context, 'info', 'usd.velocities', prim.path, message);
  return false;
}
