import { IDENTITY } from '../../../math/quat.ts';
import { length, sub, type Vec3 } from '../../../math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../../physics/constants.ts';
import { isCubic } from '../../../scene/motion/cubicPoints.ts';
import { pointSamples, poseAt, poseSamples, restingPose, vertexPositions } from '../../../scene/motion/motion.ts';
import type { Pose, SampledMotion, SampledPointsMotion, SceneObject, StaticMotion } from '../../../scene/types.ts';

/** A shape of a thing whose shapes take turns, and when it is that shape [s]. */
export interface TurnShape {
  readonly object: SceneObject;
  /** −∞ of the first. */
  readonly from: number;
  /** ∞ of the last. */
  readonly until: number;
  /** When its last life ends [s]. */
  readonly death: number;
}

/** How a prim moves whose shapes take turns: by a transform over time, in which each shape is rigid; or by points. */
export interface TurnMotion {
  readonly transform: StaticMotion | SampledMotion;
  /** In the axes of the transform, if points move. */
  readonly points?: (shape: TurnShape, time: number) => Float32Array;
}

/** The shapes in the order of their times; lives of one shape are one turn. */
export function turnsOf(pieces: readonly SceneObject[]): readonly TurnShape[] {
  const starts = pieces.flatMap((piece, i) => (i === 0 || !isSameShape(piece, pieces[i - 1]) ? [i] : []));
  return starts.map((start, k) => ({
    object: pieces[start],
    from: k === 0 ? Number.NEGATIVE_INFINITY : pieces[start].lifetime.birth,
    until: pieces[starts[k + 1]]?.lifetime.birth ?? Number.POSITIVE_INFINITY,
    death: pieces[(starts[k + 1] ?? pieces.length) - 1].lifetime.death,
  }));
}

const isSameShape = (a: SceneObject, b: SceneObject): boolean =>
  a.motion === b.motion &&
  a.mesh.positions === b.mesh.positions &&
  a.mesh.indices === b.mesh.indices &&
  JSON.stringify(a.mesh.groups) === JSON.stringify(b.mesh.groups);

/** Undefined if the turns have no motion that one prim can have. */
export function turnMotion(turns: readonly TurnShape[]): TurnMotion | undefined {
  const [first] = turns;
  const frame = { authoredIn: first.object.authoredIn, doubleSided: first.object.mesh.doubleSided };
  if (
    turns.some(({ object }) => object.authoredIn !== frame.authoredIn || object.mesh.doubleSided !== frame.doubleSided)
  )
    return undefined;
  const motions = turns.map(({ object }) => object.motion);
  if (motions.every((motion) => restingPose(motion) ?? poseSamples(motion))) {
    const transform = joinedPoses(turns);
    if (transform) return { transform };
  }
  const arePoints = motions.every((motion) => {
    const samples = pointSamples(motion);
    return samples ? !isCubic(samples) : restingPose(motion);
  });
  return arePoints && frame.authoredIn === 'world' ? pointMotion(turns) : undefined;
}

/** Greatest distance of one turn's last pose from the next one's first [m], and of their quaternions. */
const POSE_TOLERANCE = 1e-6;

/** The poses of all turns as one motion; undefined if it would jump. */
function joinedPoses(turns: readonly TurnShape[]): StaticMotion | SampledMotion | undefined {
  const times: number[] = [];
  const poses: Pose[] = [];
  for (const [i, { object, from, until }] of turns.entries()) {
    const poseOf = (time: number): Pose => poseAt(object.motion, time, SPEED_OF_LIGHT);
    if (i > 0 && !leadsTo(turns[i - 1], from, poseOf(from))) return undefined;
    const own = poseSamples(object.motion)?.times.filter((time) => time > from && time < until) ?? [];
    for (const time of [...(Number.isFinite(from) ? [from] : []), ...own]) {
      times.push(time);
      poses.push(poseOf(time));
    }
  }
  const [rest] = poses;
  const still = restingPose(turns[0].object.motion);
  if (!rest || (still && poses.every((pose) => isNear(pose, still)))) return still && { kind: 'static', pose: still };
  if (times.length < 2) return undefined;
  const numbers = poses.flatMap(({ position, orientation }) => [...position, ...orientation]);
  return { kind: 'sampled', times: Float64Array.from(times), poses: Float64Array.from(numbers) };
}

/** Whether a turn, as long as it lives, does not notice that the next one begins with a pose. */
function leadsTo({ object: { motion }, death }: TurnShape, from: number, pose: Pose): boolean {
  const isSampled = (poseSamples(motion)?.times.at(-1) ?? Number.NEGATIVE_INFINITY) >= death;
  return (isSampled && death < from) || isNear(poseAt(motion, from, SPEED_OF_LIGHT), pose);
}

const isNear = (a: Pose, b: Pose): boolean =>
  length(sub(a.position, b.position)) <= POSE_TOLERANCE &&
  a.orientation.every((x, i) => Math.abs(x - b.orientation[i]) <= POSE_TOLERANCE);

function pointMotion(turns: readonly TurnShape[]): TurnMotion {
  const { motion } = turns[0].object;
  const origin: Vec3 = pointSamples(motion)?.origin ?? restingPose(motion)!.position;
  return {
    transform: { kind: 'static', pose: { position: origin, orientation: IDENTITY } },
    points: ({ object }, time) =>
      Float32Array.from(vertexPositions(object, time, SPEED_OF_LIGHT), (x, i) => x - origin[i % 3]),
  };
}

/** The times at which a turn's points are written [s], at least one: its first, and its samples. */
export function pointTimes({ object, from, until }: TurnShape, start: number): readonly number[] {
  const own = pointSamples(object.motion)?.times.filter((time) => time > from && time < until) ?? [];
  if (Number.isFinite(from)) return [from, ...own];
  return own.length > 0 ? [...own] : [Math.min(start, until - 1)];
}

/** Until when the points move on after a time of `pointTimes` [s]; undefined if they rest. */
export function movesUntil({ object, until }: TurnShape, time: number, next: number | undefined): number | undefined {
  const last = (pointSamples(object.motion) as SampledPointsMotion | undefined)?.times.at(-1) ?? time;
  return last > time ? (next ?? (Number.isFinite(until) ? until : undefined)) : undefined;
}
