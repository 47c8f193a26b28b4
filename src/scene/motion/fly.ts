import { add, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import { boundingBox } from '../bounds/bounds.ts';
import { isListed } from '../streaming/samplePoints.ts';
import type { LocalLight, Scene, SceneObject } from '../types.ts';
import type { FlightPath } from './kinds/changes.ts';
import { deforms, pointSamples, poseAt } from './motion.ts';
import { motionKind } from './motions.ts';

/** A flight along a straight line at constant speed. */
export interface Flight {
  /** Prim path of an object or of a group. */
  readonly path: string;
  /** In units of c, world frame, |β| < 1. */
  readonly beta: Vec3;
  /** World time at which it passes the place where it would be without the flight [s]. */
  readonly at: number;
  /** Whether the mesh is the shape in the world during the flight, or the shape at rest, which the flight contracts. */
  readonly authoredIn: SceneObject['authoredIn'];
}

/** Greatest number of coordinates in a deforming mesh's samples that can fly, since they are copied. */
const MAX_COPIED_NUMBERS = 2 ** 25;

/** Whether a path is `root` or below it. */
export const isAtOrBelow = (path: string, root: string): boolean => path === root || path.startsWith(`${root}/`);

/** Objects with too many samples to fly; those that are not in memory are never too many. */
export const tooLargeToFly = (scene: Scene, path: string): readonly string[] =>
  scene.objects
    .filter(({ motion, mesh, ...object }) => {
      const samples = pointSamples(motion);
      if (!samples || !isListed(samples.points) || !isAtOrBelow(object.path, path)) return false;
      return samples.times.length * mesh.positions.length > MAX_COPIED_NUMBERS;
    })
    .map((object) => object.path);

/**
 * The scene with an object or group and all below it, including lights, flying: x(t) = x(at) + βc (t − at).
 *
 * Rigid objects keep the pose that they have at that time; their own motion is replaced. Deforming objects keep
 * deforming: every sample is shifted by βc (t − at), so that velocities add in the world frame;
 * before their first and after their last sample they keep their shape and fly on for a while. They are always authored in the world.
 *
 * `authoredIn: 'rest'`: all parts together are the shape at rest: their places are contracted towards the centre of the group. c [m/s].
 * @example
 * const scene = makeScene({ name: 'one', objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * const flying = fly(scene, { path: '/Ball', beta: [0.8, 0, 0], at: 2, authoredIn: 'rest' }, 10);
 * poseAt(flying.objects[0].motion, 3, 10).position; // [8, 0, 0] m
 */
export function fly(scene: Scene, flight: Flight, c: number): Scene {
  const flying = scene.objects.filter(({ path }) => isAtOrBelow(path, flight.path));
  const flyingLights = scene.lights.filter(
    (light): light is LocalLight => 'motion' in light && isAtOrBelow(light.path, flight.path),
  );
  const origins = [...flying, ...flyingLights].flatMap(({ motion }) => poseAt(motion, flight.at, c).position);
  const box = boundingBox(origins);
  const u = properVelocity(flight.beta);
  const middle = box ? scale(add(box.min, box.max), 0.5) : ZERO;
  const place = (x: Vec3): Vec3 => (flight.authoredIn === 'rest' ? add(middle, contraction(sub(x, middle), u)) : x);
  const flightPath: FlightPath = {
    velocity: scale(flight.beta, c),
    at: flight.at,
    c,
    place,
    range: scene.endTime - scene.startTime,
  };
  return {
    ...scene,
    objects: scene.objects.map((object) => (flying.includes(object) ? flyObject(object, flight, flightPath) : object)),
    lights: scene.lights.map((light) =>
      'motion' in light && flyingLights.includes(light)
        ? { ...light, motion: motionKind(light.motion).fly(light.motion, flightPath) }
        : light,
    ),
  };
}

function flyObject(object: SceneObject, { authoredIn }: Flight, path: FlightPath): SceneObject {
  const { motion } = object;
  return {
    ...object,
    motion: motionKind(motion).fly(motion, path),
    authoredIn: deforms(motion) ? 'world' : authoredIn,
  };
}
