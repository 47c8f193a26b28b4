import type { Lifetime, Light, Scene, SceneCamera, SceneObject } from '../types.ts';
import { type LinearTimeMap, toWorldTime } from './kinds/changes.ts';
import { motionKind } from './motions.ts';

/** An animation starts at `start + offset` and is played `speed` times as fast. */
export interface Timing {
  /** [s] */
  readonly offset: number;
  /** Above 0. */
  readonly speed: number;
}

/**
 * The scene with its animation retimed: x′(t) = x(τ), t = start + offset + (τ − start)/speed. This applies to everything that has a time:
 * motions, lifetimes, lights, cameras, the time range.
 *
 * Hyperbolic motion played k times as fast would approach k c; its proper acceleration is multiplied by k²
 * instead, which is the same motion at low speeds and never reaches c. So a scene that is played k times as fast
 * with a speed of light of k c shows exactly what it showed before.
 * @example
 * retime(makeScene({ name: 'empty', startTime: 1, endTime: 9 }), { offset: 0, speed: 2 }).endTime; // 5 s
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

const retimeObject = (object: SceneObject, map: LinearTimeMap): SceneObject => ({
  ...object,
  motion: motionKind(object.motion).retime(object.motion, map),
  lifetime: retimeLifetime(object.lifetime, map),
});

function retimeLight(light: Light, map: LinearTimeMap): Light {
  if ('film' in light && light.film) {
    const { start, speed } = light.film;
    return { ...light, film: { ...light.film, start: toWorldTime(start, map), speed: speed / map.a } };
  }
  if (!('motion' in light)) return light;
  const motion = motionKind(light.motion).retime(light.motion, map);
  return { ...light, motion, lifetime: retimeLifetime(light.lifetime, map) };
}

const retimeCamera = (camera: SceneCamera, map: LinearTimeMap): SceneCamera => ({
  ...camera,
  motion: motionKind(camera.motion).retime(camera.motion, map),
});

const retimeLifetime = ({ birth, death }: Lifetime, map: LinearTimeMap): Lifetime => ({
  birth: toWorldTime(birth, map),
  death: toWorldTime(death, map),
});
