import { type Message, msg } from '../../messages/message.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { LAYERS } from '../../scene/materials/layered.ts';
import { deformedNormals, smoothingGroups } from '../../scene/mesh/normals.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import { pointSamples } from '../../scene/motion/motion.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import { isBlended, isStreamed, pointsAt } from '../../scene/streaming/samplePoints.ts';
import { withoutNonFiniteVertices } from '../../scene/streaming/streamedPoints.ts';
import type {
  Diagnostic,
  DomeLight,
  Light,
  LocalLight,
  Material,
  Mesh,
  Motion,
  SampledPointsMotion,
  Scene,
  SceneCamera,
  SceneObject,
} from '../../scene/types.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';

/**
 * Makes all numbers of a scene finite: files hold NaN and infinities, and finite numbers overflow when converted to
 * metres in f32. Elements without valid numbers are removed, or replaced where the shape does not depend on them, and
 * reported.
 */
export function sanitizeScene(scene: Scene): Scene {
  const found: Diagnostic[] = [];
  const say = (path: string, message: Message): void => {
    found.push({ severity: 'warning', code: NOT_FINITE, place: `${scene.name}<${path}>`, message });
  };
  const sound: Scene = {
    ...scene,
    ...sanitizeTimes(scene, say),
    objects: sanitizeObjects(scene.objects, say),
    materials: scene.materials.map((material) => sanitizeMaterial(material, say)),
    lights: scene.lights.filter((light) => isFiniteItem(light, say)),
    cameras: scene.cameras.filter((camera) => isFiniteItem(camera, say)),
  };
  return found.length > 0 ? { ...sound, diagnostics: [...scene.diagnostics, ...found] } : scene;
}

const NOT_FINITE: DiagnosticCode = 'file.not-finite';

type ReportIssue = (path: string, message: Message) => void;

const NOT_FINITE_TEXT = msg`not a finite number (NaN, or too large)`;

function sanitizeTimes({ startTime, endTime }: Scene, say: ReportIssue): Pick<Scene, 'startTime' | 'endTime'> {
  if (Number.isFinite(startTime) && Number.isFinite(endTime)) return { startTime, endTime };
  say(
    '/',
    msg`the animation lasts from ${startTime} to ${endTime} s, which is ${NOT_FINITE_TEXT}; it is shown from 0 s`,
  );
  return { startTime: 0, endTime: Number.isFinite(endTime) ? Math.max(0, endTime) : 0 };
}

function sanitizeObjects(objects: readonly SceneObject[], say: ReportIssue): SceneObject[] {
  const known = new Map<Mesh, Mesh>();
  return objects.flatMap((object) => {
    if (!isMotionFinite(object, say)) return [];
    const lost = nonFiniteVertices(object);
    const mesh = lost ? withoutVertices(object, lost, say) : object.mesh;
    const sound = known.get(mesh) ?? withFiniteAttributes(mesh, object.path, say);
    known.set(mesh, sound);
    const motion = withFiniteNormals(lost ? zeroVertices(lost, object.motion) : object.motion, sound);
    return [sound === object.mesh && motion === object.motion ? object : { ...object, mesh: sound, motion }];
  });
}

/** Whether all numbers are finite: x · 0 is 0 only for finite x, and NaN persists in a sum. */
function allFinite(numbers: ArrayLike<number>): boolean {
  if (numbers instanceof Float32Array)
    return areFiniteBits(new Uint32Array(numbers.buffer, numbers.byteOffset, numbers.length));
  let sum = 0;
  for (let i = 0; i < numbers.length; i++) sum += numbers[i] * 0;
  return sum === 0;
}

/** All exponent bits set: NaN and infinities. */
const EXPONENT_MASK = 0x7f800000;

/** The same for f32 by bit pattern, faster for long caches. */
function areFiniteBits(bits: Uint32Array): boolean {
  for (let i = 0; i < bits.length; i++) if ((bits[i] & EXPONENT_MASK) === EXPONENT_MASK) return false;
  return true;
}

function isMotionFinite({ path, motion }: { path: string; motion: Motion }, say: ReportIssue): boolean {
  if (motionKind(motion).numbers(motion).every(allFinite)) return true;
  say(path, msg`where it is, or how it moves, is ${NOT_FINITE_TEXT}; it is left out`);
  return false;
}

/** Results cached per array, since objects share them. */
const FINITE = new WeakMap<readonly Float32Array[] | Float32Array, boolean>();

/** Whether all numbers of one array, or of all in a list, are finite. */
function cachedAllFinite(numbers: readonly Float32Array[] | Float32Array): boolean {
  const known = FINITE.get(numbers);
  if (known !== undefined) return known;
  const found = ArrayBuffer.isView(numbers) ? allFinite(numbers) : numbers.every(allFinite);
  FINITE.set(numbers, found);
  return found;
}

const NO_POINTS: readonly Float32Array[] = [];

/** 1 for each vertex with a non-finite position, at rest or at a sample; undefined if none. */
function nonFiniteVertices({ mesh, motion }: SceneObject): Uint8Array | undefined {
  const points = pointSamples(motion)?.points ?? NO_POINTS;
  if (isStreamed(points)) return points.statistics.nonFiniteVertices;
  if (isBlended(points)) return points.nonFiniteVertices;
  if (cachedAllFinite(mesh.positions) && cachedAllFinite(points)) return undefined;
  const broken = [mesh.positions, ...points].filter((shape) => !allFinite(shape));
  const lost = new Uint8Array(mesh.positions.length / 3);
  for (const shape of broken)
    for (let i = 0; i < shape.length; i++) if (!Number.isFinite(shape[i])) lost[Math.floor(i / 3)] = 1;
  return lost;
}

/** The mesh without triangles that use these vertices. */
function withoutVertices({ path, mesh }: SceneObject, lost: Uint8Array, say: ReportIssue): Mesh {
  const indices: number[] = [];
  const groups = mesh.groups.map(({ start, count, material }) => {
    const first = indices.length;
    for (let i = start; i < start + count; i += 3) {
      const corners = mesh.indices.subarray(i, i + 3);
      if (!corners.some((vertex) => lost[vertex] === 1)) indices.push(...corners);
    }
    return { start: first, count: indices.length - first, material };
  });
  const count = lost.reduce((sum, one) => sum + one, 0);
  const triangles = (mesh.indices.length - indices.length) / 3;
  say(
    path,
    msg`the place of ${count} of ${lost.length} points is ${NOT_FINITE_TEXT}; their ${triangles} triangles are left out`,
  );
  const positions = zeroPoints(mesh.positions, lost);
  return { ...withoutQuadric(mesh), positions, indices: Uint32Array.from(indices), groups };
}

function zeroVertices(lost: Uint8Array, motion: Motion): Motion {
  const samples = pointSamples(motion);
  if (!samples) return motion;
  const { points } = samples;
  return {
    ...samples,
    points: finitePoints(points, lost),
  };
}

/** Blended points have their vertices that are not finite at the origin already. */
function finitePoints(points: SampledPointsMotion['points'], lost: Uint8Array): SampledPointsMotion['points'] {
  if (isStreamed(points)) return withoutNonFiniteVertices(points);
  return isBlended(points) ? points : points.map((list) => zeroPoints(list, lost));
}

const zeroPoints = (points: Float32Array, lost: Uint8Array): Float32Array =>
  points.map((x, i) => (lost[Math.floor(i / 3)] === 1 ? 0 : x));

/** Recomputes non-finite sample normals from the points. */
function withFiniteNormals(motion: Motion, mesh: Mesh): Motion {
  const samples = pointSamples(motion);
  if (!samples?.normals || cachedAllFinite(samples.normals)) return motion;
  const groups = smoothingGroups(mesh);
  const computed = (k: number): Float32Array => finite(deformedNormals(pointsAt(samples, k), mesh.indices, groups));
  return { ...samples, normals: samples.normals.map((normals, k) => (allFinite(normals) ? normals : computed(k))) };
}

/** With finite normals and UVs. */
function withFiniteAttributes(mesh: Mesh, path: string, say: ReportIssue): Mesh {
  const { positions, normals, uvs, colors, indices } = mesh;
  const bad = [normals, uvs, colors ?? []].map((numbers) => !allFinite(numbers));
  if (!bad.includes(true)) return mesh;
  if (bad[0]) say(path, msg`some of its normals are ${NOT_FINITE_TEXT}; they are computed anew`);
  if (bad[1]) say(path, msg`some of its texture coordinates are ${NOT_FINITE_TEXT}; they are taken as 0`);
  if (bad[2]) say(path, msg`some of its colours are ${NOT_FINITE_TEXT}; they are taken as 0`);
  const computed = bad[0] && deformedNormals(positions, indices, smoothingGroups(mesh));
  return {
    ...mesh,
    ...(computed ? { normals: normals.map((_, i) => unitOr(normals, computed, i)) } : {}),
    uvs: finite(uvs),
    ...(colors ? { colors: finite(colors) } : {}),
  };
}

/** Component i of the vertex's own normal, where all of that is finite. */
function unitOr(own: Float32Array, computed: Float32Array, i: number): number {
  const first = i - (i % 3);
  if (allFinite(own.subarray(first, first + 3))) return own[i];
  return Number.isFinite(computed[i]) ? computed[i] : i % 3 === 2 ? 1 : 0;
}

const finite = (numbers: Float32Array): Float32Array =>
  allFinite(numbers) ? numbers : numbers.map((x) => (Number.isFinite(x) ? x : 0));

function sanitizeMaterial(material: Material, say: ReportIssue): Material {
  const { name, baseColor, emissive, roughness, metallic, opacity, opacityThreshold, ior } = material;
  const numbers = [
    ...baseColor,
    ...emissive,
    roughness,
    metallic,
    opacity,
    opacityThreshold,
    ior ?? 1,
    ...layerNumbers(material),
  ];
  if (allFinite(numbers)) return material;
  say(name, msg`a number of the material is ${NOT_FINITE_TEXT}; it is shown in grey`);
  return makeMaterial({ name });
}

/** All numbers of its layers. */
const layerNumbers = (material: Material): number[] =>
  LAYERS.flatMap((name) => Object.entries(material[name] ?? {})).flatMap(([slot, value]) =>
    slot === 'attenuationDistance' ? [] : [value].flat().filter((each) => typeof each === 'number'),
  );

function isFiniteItem(thing: Light | SceneCamera, say: ReportIssue): boolean {
  if ('motion' in thing && !isMotionFinite(thing, say)) return false;
  const {
    lifetime: _,
    shaping,
    gradient,
    ...rest
  }: Partial<LocalLight> & Pick<DomeLight, 'gradient'> = thing as Partial<LocalLight>;
  const numbers = [rest, shaping ?? {}, gradient ?? {}].flatMap((part) => Object.values(part)).flat();
  if (allFinite(numbers.filter((value) => typeof value === 'number'))) return true;
  say(thing.path, msg`a number of it is ${NOT_FINITE_TEXT}; it is left out`);
  return false;
}
