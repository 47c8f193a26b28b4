import { fromAxisAngle, multiply, type Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { type Message, msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { objectBoundingSphere } from '../../scene/bounds/bounds.ts';
import { deformedNormals, smoothingGroups } from '../../scene/mesh/normals.ts';
import { withoutQuadric } from '../../scene/mesh/quadric.ts';
import { isAlive, isEternal } from '../../scene/motion/lifetimes.ts';
import { poseAt, poseSamples, restToWorld, vertexPositions } from '../../scene/motion/motion.ts';
import { samplePose } from '../../scene/motion/poses.ts';
import { sampleMotion } from '../../scene/motion/resample.ts';
import type {
  Diagnostic,
  Motion,
  Pose,
  RigidMotion,
  SampledMotion,
  SampledPointsMotion,
  Scene,
  SceneObject,
  StaticMotion,
} from '../../scene/types.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';

/** Motions that file formats without relativity can express. */
export type ExportMotion = StaticMotion | SampledMotion | SampledPointsMotion;

/** Maximum distance of a sampled path from the closed form, as a fraction of the object's size. */
const CHORD_TOLERANCE = 1e-4;

/** A saved scene: its files, and what they cannot say. */
export interface ExportedScene {
  /** Contents by path relative to the main file, which is first. */
  readonly files: ReadonlyMap<string, Uint8Array>;
  /** Losses of the export. */
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Objects for formats without relativity: geometry in the world frame, motions sampled over the scene's time range, of pieces that take turns one. Losses
 * are reported in `losses`.
 */
export function exportObjects(
  scene: Scene,
  losses: DiagnosticLog,
): (SceneObject & { readonly motion: ExportMotion })[] {
  return [...turnsByPath(scene.objects)].map(([path, turns]) => {
    const object = turns.find(({ lifetime }) => isAlive(lifetime, scene.startTime)) ?? turns[0];
    const { birth, death } = object.lifetime;
    if (turns.length > 1)
      losses.add(
        'warning',
        'convert.lifetime',
        path,
        msg`it is ${turns.length} pieces that take turns; only the one of the start is written, and there it always is`,
      );
    else if (!isEternal(object.lifetime))
      losses.add(
        'warning',
        'convert.lifetime',
        object.path,
        msg`it lives from ${inSeconds(birth)} to ${inSeconds(death)} s; there it always is`,
      );
    const { stretch: _, ...rest } = object;
    return { ...rest, ...exportObject(object, scene, losses) };
  });
}

const inSeconds = (time: number): number | string =>
  Number.isFinite(time) ? Number(time.toPrecision(6)) : time < 0 ? '−∞' : '∞';

/** Objects, and all pieces of each thing, by the path of the whole. */
function turnsByPath(objects: readonly SceneObject[]): ReadonlyMap<string, readonly SceneObject[]> {
  const turns = new Map<string, SceneObject[]>();
  for (const object of objects) {
    const path = object.pieceOf ?? object.path;
    const own = turns.get(path);
    if (own) own.push(object);
    else turns.set(path, [object]);
  }
  return turns;
}

function exportObject(object: SceneObject, scene: Scene, losses: DiagnosticLog) {
  const c = scene.hints.speedOfLight ?? SPEED_OF_LIGHT;
  const own = restToWorld(object, c);
  const { motion, mesh, stretch } = own;
  const shape = { mesh, ...(stretch && { stretch }) };
  if (isExportable(motion)) return { ...shape, motion };
  const { radius, center } = objectBoundingSphere(own);
  const reach = radius + Math.hypot(...center);
  const range = [scene.startTime, Math.max(scene.endTime, scene.startTime + 1)];
  losses.add('warning', 'convert.motion', own.path, sampledFrom(motion, range));
  const { times, poses } = sampleMotion((t) => poseAt(motion, t, c), range, reach, CHORD_TOLERANCE * reach);
  if (own.authoredIn === 'world') return { ...shape, motion: { kind: 'sampled', times, poses } as const };
  return contracted(own, times, samplePose(poses, 0).position, c);
}

/** Kinds of motion that are sampled, in words. */
const SAMPLED_TEXTS: { readonly [K in Exclude<Motion, ExportMotion>['kind']]: Message } = {
  uniform: msg`its uniform motion`,
  hyperbolic: msg`its hyperbolic motion`,
};

const isExportable = (motion: Motion): motion is ExportMotion => !Object.hasOwn(SAMPLED_TEXTS, motion.kind);

const sampledFrom = ({ kind }: Exclude<Motion, ExportMotion>, range: readonly number[]): Message =>
  msg`${SAMPLED_TEXTS[kind]} is sampled from ${range[0]} to ${range[1]} s; before and after it rests`;

/** A mesh authored in its rest frame, as world-frame points at the given times. */
function contracted(object: SceneObject, times: Float64Array, origin: Vec3, c: number) {
  const points = Array.from(times, (t) =>
    Float32Array.from(vertexPositions(object, t, c), (x, i) => x - origin[i % 3]),
  );
  const groups = smoothingGroups(object.mesh);
  const normals = points.map((p) => deformedNormals(p, object.mesh.indices, groups));
  const mesh = { ...withoutQuadric(object.mesh), positions: points[0], normals: normals[0] };
  return { mesh, motion: { kind: 'sampled-points', times, origin, points, normals } as const };
}

/** The motion of a light or camera, sampled if the format cannot express it. */
export function exportRigidMotion(
  motion: RigidMotion,
  scene: Scene,
  path: string,
  losses: DiagnosticLog,
): StaticMotion | SampledMotion {
  if (isExportable(motion)) return motion;
  const c = scene.hints.speedOfLight ?? SPEED_OF_LIGHT;
  const range = [scene.startTime, Math.max(scene.endTime, scene.startTime + 1)];
  losses.add('warning', 'convert.motion', path, sampledFrom(motion, range));
  return { kind: 'sampled', ...sampleMotion((t) => poseAt(motion, t, c), range, 1, CHORD_TOLERANCE) };
}

const TO_Y_UP: Quat = fromAxisAngle([1, 0, 0], -Math.PI / 2);

/** A vector of the scene in Y-up axes; exact, since components are only permuted and negated. */
export const vectorYUp = (scene: Scene, [x, y, z]: Vec3): Vec3 => (scene.upAxis === 'Y' ? [x, y, z] : [x, z, -y]);
/** An orientation of the scene in Y-up axes; the object's local axes stay. */
export const orientationYUp = (scene: Scene, q: Quat): Quat => (scene.upAxis === 'Y' ? q : multiply(TO_Y_UP, q));

/** Poses at the samples' times; one if static. */
export function exportPoses(motion: ExportMotion): readonly Pose[] {
  const samples = poseSamples(motion);
  if (!samples) return [poseAt(motion, 0, SPEED_OF_LIGHT)];
  return Array.from(samples.times, (_, i) => samplePose(samples.poses, i));
}

/** The scene with all motions expressible without relativity, and its lifetimes; losses are added to `notes`. */
export function exportSampledScene(scene: Scene, notes: DiagnosticLog): Scene {
  return {
    ...scene,
    endTime: Math.max(scene.endTime, scene.startTime + 1),
    objects: scene.objects.map((object) => {
      const { stretch: _, ...rest } = object;
      return { ...rest, ...exportObject(object, scene, notes), authoredIn: 'world' };
    }),
    lights: scene.lights.map((light) =>
      'motion' in light ? { ...light, motion: exportRigidMotion(light.motion, scene, light.path, notes) } : light,
    ),
  };
}
