import { add, addScaled, length, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { boundingBox } from '../bounds/bounds.ts';
import { isStreamed } from '../streaming/samplePoints.ts';
import { translateStreamedPoints } from '../streaming/streamedPoints.ts';
import type { LocalLight, RigidMotion, SampledPointsMotion, Scene, SceneObject } from '../types.ts';
import { poseAt } from './motion.ts';

/** A flight along a straight line at constant speed. */
export interface Flight {
  /** Prim path: of an object, or of what holds several. */
  readonly path: string;
  /** In units of c, world frame, |β| < 1. */
  readonly beta: Vec3;
  /** World time at which it passes the place where it would be without the flight [s]. */
  readonly at: number;
  /** What the mesh is: the shape in the world as it flies by, or the shape at rest, which the flight contracts. */
  readonly authoredIn: SceneObject['authoredIn'];
}

/** Most numbers of a deforming mesh's samples that are carried along: each is copied. */
const MAX_COPIED_NUMBERS = 2 ** 25;
/** How long a deforming thing flies on before its first and after its last sample [s], in lengths of the animation. */
const LEAD = 20;
const MIN_LEAD = 60;

/** Whether a thing is the one of a path, or below it. */
export const isAtOrBelow = (path: string, wanted: string): boolean => path === wanted || path.startsWith(`${wanted}/`);

/** Objects whose samples are too many to be carried along; those that are left in a file never are. */
export const tooLargeToFly = (scene: Scene, path: string): readonly string[] =>
  scene.objects
    .filter(({ motion, mesh, ...object }) => {
      if (motion.kind !== 'sampled-points' || isStreamed(motion.points) || !isAtOrBelow(object.path, path))
        return false;
      return motion.times.length * mesh.positions.length > MAX_COPIED_NUMBERS;
    })
    .map((object) => object.path);

/**
 * The scene with a thing and all below it, lamps too, flying: x(t) = x(at) + βc (t − at).
 *
 * Rigid things keep the pose that they have at that time, and what moved them before is gone. Things that deform go on
 * deforming: every sample is shifted by βc (t − at), so that their own motion adds to it as velocities of the world frame do;
 * before their first and after their last sample they keep their shape and fly on for a while. They are always the world's.
 *
 * `rest`: all the parts together are the shape at rest: their places are contracted towards the middle of what flies. c [m/s].
 */
export function fly(scene: Scene, flight: Flight, c: number): Scene {
  const flying = scene.objects.filter(({ path }) => isAtOrBelow(path, flight.path));
  const lamps = scene.lights.filter(
    (light): light is LocalLight => 'motion' in light && isAtOrBelow(light.path, flight.path),
  );
  const origins = [...flying, ...lamps].flatMap(({ motion }) => poseAt(motion, flight.at, c).position);
  const box = boundingBox(origins);
  const u = properVelocity(flight.beta);
  const middle = box ? scale(add(box.min, box.max), 0.5) : ZERO;
  const place = (x: Vec3): Vec3 => (flight.authoredIn === 'rest' ? add(middle, contraction(sub(x, middle), u)) : x);
  const course: FlightPath = {
    velocity: scale(flight.beta, c),
    at: flight.at,
    c,
    place,
    range: scene.endTime - scene.startTime,
  };
  return {
    ...scene,
    objects: scene.objects.map((object) => (flying.includes(object) ? flyObject(object, flight, course) : object)),
    lights: scene.lights.map((light) =>
      'motion' in light && lamps.includes(light) ? { ...light, motion: flyFrame(light.motion, course) } : light,
    ),
  };
}

interface FlightPath {
  /** [m/s] */
  readonly velocity: Vec3;
  /** [s] */
  readonly at: number;
  readonly c: number;
  /** Where what is at a place at rest is in flight, at the time `at`. */
  readonly place: (x: Vec3) => Vec3;
  /** Of the scene's time [s]. */
  readonly range: number;
}

function flyObject(object: SceneObject, { authoredIn }: Flight, course: FlightPath): SceneObject {
  const { motion } = object;
  if (motion.kind === 'sampled-points')
    return { ...object, motion: translatePoints(motion, course), authoredIn: 'world' };
  return { ...object, motion: flyFrame(motion, course), authoredIn };
}

function flyFrame(motion: RigidMotion, { velocity, at, c, place }: FlightPath): RigidMotion {
  const pose = poseAt(motion, at, c);
  const position = place(pose.position);
  if (length(velocity) === 0) return { kind: 'static', pose: { ...pose, position } };
  return { kind: 'uniform', pose: { ...pose, position: addScaled(position, velocity, -at) }, velocity };
}

/** As a share of the motion's time. */
const JUMP = 1e-6;

function translatePoints(motion: SampledPointsMotion, { velocity, at, range }: FlightPath): SampledPointsMotion {
  const { times, points, velocities, normals } = motion;
  const last = times.length - 1;
  const lead = Math.max(MIN_LEAD, LEAD * range);
  // A cubic has one velocity at a sample: what it jumps by where it begins and ends takes a short piece more.
  const jump = velocities ? [JUMP * (times[last] - times[0])] : [];
  const before = [lead, ...jump].map((ahead) => times[0] - ahead);
  const after = [...jump, lead].map((behind) => times[last] + behind);
  const order = [...before.map(() => 0), ...times.keys(), ...after.map(() => last)];
  const longer = Float64Array.of(...before, ...times, ...after);
  const moves = (i: number): boolean => i >= before.length && i < before.length + times.length;
  const shifts = Float64Array.from(order.flatMap((_, i) => scale(velocity, longer[i] - at)));
  if (isStreamed(points)) return { ...motion, times: longer, points: translateStreamedPoints(points, order, shifts) };
  const shifted = order.map((k, i) => points[k].map((x, j) => x + shifts[3 * i + (j % 3)]));
  return {
    ...motion,
    times: longer,
    points: shifted,
    ...(velocities && {
      velocities: order.map((k, i) => velocities[k].map((v, j) => (moves(i) ? v : 0) + velocity[j % 3])),
    }),
    ...(normals && { normals: order.map((k) => normals[k]) }),
  };
}
