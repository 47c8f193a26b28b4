import type { ObserverEvent } from '../../physics/worldLines/kinds/worldLineKind.ts';
import { emissionTime } from '../../physics/worldLines/lightCone.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { motionKind } from '../motion/motions.ts';
import type { Scene, SceneObject } from '../types.ts';
import { type BoundingBox, boundingBox } from './bounds.ts';

/** The box of an object at world time t [s]; of one whose samples are left in a file between the boxes of its samples. */
export const objectBounds = (object: SceneObject, t: number, c: number): BoundingBox | undefined =>
  motionKind(object.motion).bounds(object, t, c);

/** The box of all that exists at world time t [s]; undefined where nothing does. c [m/s]. */
export function sceneBounds(scene: Scene, t: number, c: number): BoundingBox | undefined {
  const corners: number[] = [];
  for (const object of scene.objects) {
    if (t < object.lifetime.birth || t > object.lifetime.death) continue;
    const box = objectBounds(object, t, c);
    if (box) corners.push(...box.min, ...box.max);
  }
  return boundingBox(corners);
}

/**
 * World times [s] between which lies the emission of every point that stays within `radius` [m] of `center`, in the world
 * frame: those of the centre for observers who look radius/c earlier and later at the same place. undefined where the
 * centre's horizon hides it from one of them.
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
