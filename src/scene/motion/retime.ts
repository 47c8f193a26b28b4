import { addScaled, scale } from '../../math/vec3.ts';
import type { Lifetime, Light, Motion, RigidMotion, Scene, SceneCamera, SceneObject } from '../types.ts';

/** How an animation is run: from `start + offset` on, `speed` times as fast. */
export interface Timing {
  /** [s] */
  readonly offset: number;
  /** Above 0. */
  readonly speed: number;
}

/** World time of what a file has at its own time τ: t = a τ + b [s]. */
interface LinearTimeMap {
  readonly a: number;
  readonly b: number;
}

/**
 * The scene with its animation run otherwise: x′(t) = x(τ), t = start + offset + (τ − start)/speed. Everything that has a time
 * is carried along: motions, lifetimes, lamps, cameras, the time range.
 *
 * Hyperbolic motion cannot be run k times as fast as it is, or it would near k c; its proper acceleration is k² times the
 * file's instead, which is the same motion at low speeds and never reaches c. So a scene that is run k times as fast and seen
 * at a speed of light of k c shows exactly what it did before.
 */
export function retime(scene: Scene, { offset, speed }: Timing): Scene {
  if (offset === 0 && speed === 1) return scene;
  const a = 1 / speed;
  const map = { a, b: scene.startTime * (1 - a) + offset };
  const { hints } = scene;
  return {
    ...scene,
    startTime: toWorldTime(scene.startTime, map),
    endTime: toWorldTime(scene.endTime, map),
    objects: scene.objects.map((object) => retimeObject(object, map)),
    lights: scene.lights.map((light) => retimeLight(light, map)),
    cameras: scene.cameras.map((camera) => retimeCamera(camera, map)),
    hints: hints.openAt === undefined ? hints : { ...hints, openAt: toWorldTime(hints.openAt, map) },
  };
}

const toWorldTime = (t: number, { a, b }: LinearTimeMap): number => a * t + b;

const retimeObject = (object: SceneObject, map: LinearTimeMap): SceneObject => ({
  ...object,
  motion: retimeMotion(object.motion, map),
  lifetime: retimeLifetime(object.lifetime, map),
});

const retimeLight = (light: Light, map: LinearTimeMap): Light =>
  'motion' in light
    ? { ...light, motion: retimeMotion(light.motion, map), lifetime: retimeLifetime(light.lifetime, map) }
    : light;

const retimeCamera = (camera: SceneCamera, map: LinearTimeMap): SceneCamera => ({
  ...camera,
  motion: retimeMotion(camera.motion, map),
});

const retimeLifetime = ({ birth, death }: Lifetime, map: LinearTimeMap): Lifetime => ({
  birth: toWorldTime(birth, map),
  death: toWorldTime(death, map),
});

function retimeMotion<M extends Motion | RigidMotion>(motion: M, map: LinearTimeMap): M;
function retimeMotion(motion: Motion, map: LinearTimeMap): Motion {
  const { a, b } = map;
  switch (motion.kind) {
    case 'static':
      return motion;
    case 'uniform': {
      // x + v τ with τ = (t − b)/a.
      const velocity = scale(motion.velocity, 1 / a);
      return { ...motion, velocity, pose: { ...motion.pose, position: addScaled(motion.pose.position, velocity, -b) } };
    }
    case 'hyperbolic':
      return {
        ...motion,
        properAcceleration: scale(motion.properAcceleration, 1 / (a * a)),
        t0: toWorldTime(motion.t0, map),
      };
    case 'sampled':
      return { ...motion, times: motion.times.map((t) => toWorldTime(t, map)) };
    case 'sampled-points': {
      const velocities = motion.velocities?.map((each) => each.map((v) => v / a));
      return { ...motion, times: motion.times.map((t) => toWorldTime(t, map)), ...(velocities && { velocities }) };
    }
  }
}
