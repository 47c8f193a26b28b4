import { addScaled, scale } from '../math/vec3.ts';
import type { FrameMotion, Lifetime, Light, Motion, Scene, SceneCamera, SceneObject } from './types.ts';

/** How an animation is run: from `start + offset` on, `speed` times as fast. */
export interface Timing {
  /** [s] */
  readonly offset: number;
  /** Above 0. */
  readonly speed: number;
}

/** World time of what a file has at its own time τ: t = a τ + b [s]. */
interface TimeMap {
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
    startTime: mapped(scene.startTime, map),
    endTime: mapped(scene.endTime, map),
    objects: scene.objects.map((object) => retimeObject(object, map)),
    lights: scene.lights.map((light) => retimeLight(light, map)),
    cameras: scene.cameras.map((camera) => retimeCamera(camera, map)),
    hints: hints.openAt === undefined ? hints : { ...hints, openAt: mapped(hints.openAt, map) },
  };
}

const mapped = (t: number, { a, b }: TimeMap): number => a * t + b;

const retimeObject = (object: SceneObject, map: TimeMap): SceneObject => ({
  ...object,
  motion: retimeMotion(object.motion, map),
  lifetime: retimeLifetime(object.lifetime, map),
});

const retimeLight = (light: Light, map: TimeMap): Light =>
  'motion' in light
    ? { ...light, motion: retimeMotion(light.motion, map), lifetime: retimeLifetime(light.lifetime, map) }
    : light;

const retimeCamera = (camera: SceneCamera, map: TimeMap): SceneCamera => ({
  ...camera,
  motion: retimeMotion(camera.motion, map),
});

const retimeLifetime = ({ birth, death }: Lifetime, map: TimeMap): Lifetime => ({
  birth: mapped(birth, map),
  death: mapped(death, map),
});

function retimeMotion<M extends Motion | FrameMotion>(motion: M, map: TimeMap): M;
function retimeMotion(motion: Motion, map: TimeMap): Motion {
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
        t0: mapped(motion.t0, map),
      };
    case 'sampled':
      return { ...motion, times: motion.times.map((t) => mapped(t, map)) };
    case 'sampled-points': {
      const velocities = motion.velocities?.map((each) => each.map((v) => v / a));
      return { ...motion, times: motion.times.map((t) => mapped(t, map)), ...(velocities && { velocities }) };
    }
  }
}
