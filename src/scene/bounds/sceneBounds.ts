import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import { emissionTime } from '../../physics/worldLines/lightCone.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { isAlive } from '../motion/lifetimes.ts';
import { deforms, isStatic } from '../motion/motion.ts';
import { motionKind } from '../motion/motions.ts';
import type { Scene, SceneObject } from '../types.ts';
import { type BoundingBox, boundingBox } from './bounds.ts';
import type { Support } from './supportMap.ts';

/**
 * The box of an object at world time t [s]; with streamed samples, interpolated between the boxes of the samples.
 * @example
 * const flying = makeObject({
 *   path: '/Cube',
 *   mesh: box([2, 2, 2]),
 *   motion: { kind: 'uniform', pose: IDENTITY_POSE, velocity: [6, 0, 0] },
 * });
 * objectBounds(flying, 0.5, 10); // { min: [2, -1, -1], max: [4, 1, 1] } m
 */
export const objectBounds = (object: SceneObject, t: number, c: number): BoundingBox | undefined =>
  motionKind(object.motion).bounds(object, t, c);

/**
 * The box of all objects that exist at world time t [s]; undefined if none does. c [m/s].
 * @example
 * const objects = [makeObject({ path: '/Ball', mesh: box([2, 2, 2]), motion: restingAt([5, 0, 0]) })];
 * sceneBounds(makeScene({ name: 'one', objects }), 0, 10); // { min: [4, -1, -1], max: [6, 1, 1] } m
 */
export function sceneBounds(scene: Scene, t: number, c: number): BoundingBox | undefined {
  const corners: number[] = [];
  for (const object of scene.objects) {
    if (!isAlive(object.lifetime, t)) continue;
    const box = objectBounds(object, t, c);
    if (box) corners.push(...box.min, ...box.max);
  }
  return boundingBox(corners);
}

/** Moments of an animation at which a silhouette is looked at. */
const MOMENTS = 24;
/** Maximum number of places of deforming points that are computed for a silhouette; fewer moments serve larger ones. */
const MAX_PLACES = 4_000_000;

/** How far all objects reach, at whatever times of the animation they exist, and at `t` [s]; −∞ if there are none. c [m/s]. */
export function animationSupport(scene: Scene, t: number, c: number): Support {
  const { startTime, endTime, objects } = scene;
  const places = objects.reduce((n, { mesh, motion }) => n + (deforms(motion) ? mesh.positions.length / 3 : 0), 0);
  const count = Math.max(2, Math.min(MOMENTS, Math.floor(MAX_PLACES / Math.max(places, 1))));
  const moments = Array.from({ length: count }, (_, k) => startTime + (k / (count - 1)) * (endTime - startTime));
  const reaches = objects.flatMap((object) =>
    (isStatic(object.motion) ? [t] : [...new Set([t, ...moments])])
      .filter((time) => isStatic(object.motion) || isAlive(object.lifetime, time))
      .map((time) => motionKind(object.motion).support(object, time, c)),
  );
  return (d) => reaches.reduce((most, reach) => Math.max(most, reach(d)), Number.NEGATIVE_INFINITY);
}

/**
 * World times [s] that enclose the emission of every point within `radius` [m] of `center`, in the world frame: the emission times of the centre for the observer
 * radius/c earlier and later at the same position. Undefined if the centre is beyond its horizon for one of these.
 */
export function emissionWindow(
  center: WorldLine,
  radius: number,
  observer: ObserverEvent,
  c: number,
): readonly [from: number, to: number] | undefined {
  const at = (dt: number) => emissionTime(center, { ...observer, t: observer.t + dt }, c);
  const from = at(-radius / c);
  const to = at(radius / c);
  return from === undefined || to === undefined ? undefined : [from, to];
}
