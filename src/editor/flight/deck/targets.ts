import { type Boost, boostOf } from '../../../flight/boost.ts';
import { add, addScaled, length, normalize, scale, sub, type Vec3 } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../../physics/lorentz/observer.ts';
import { simultaneitySlice } from '../../../physics/worldLines/simultaneity.ts';
import { velocityAt } from '../../../physics/worldLines/worldLine.ts';
import { sceneBounds } from '../../../scene/bounds/sceneBounds.ts';
import { isStatic, originWorldLine } from '../../../scene/motion/motion.ts';
import type { Scene, SceneObject } from '../../../scene/types.ts';

/** Objects that have a rest frame to sit in: rigid ones that move. */
export const followable = ({ objects }: Scene): readonly string[] =>
  objects.filter(({ motion }) => motion.kind !== 'sampled-points' && !isStatic(motion)).map(({ path }) => path);

/** The velocity of an object where it is at the observer's moment, in the observer's own simultaneity. c [m/s]. */
export function bodyVelocity({ motion }: SceneObject, observer: ObserverState, c: number): Boost | undefined {
  if (motion.kind === 'sampled-points') return undefined;
  const line = originWorldLine(motion);
  const { ahead } = simultaneitySlice(line, observer, observer.u, c);
  return boostOf(properVelocity(scale(velocityAt(line, observer.t + ahead / c, c), 1 / c)));
}

/** How far from an object one stops: this many times half its diagonal, and this much more [m]. */
const CLEARANCE = 1.2;
const LEAST_CLEARANCE = 2;

/** A place before an object as it is now in the world, on the way there; undefined if it is not there now. c [m/s]. */
export function placeBefore(scene: Scene, path: string, observer: ObserverState, c: number): Vec3 | undefined {
  const objects = scene.objects.filter((object) => object.path === path);
  const box = objects.length > 0 ? sceneBounds({ ...scene, objects }, observer.t, c) : undefined;
  if (!box) return undefined;
  const center = scale(add(box.min, box.max), 0.5);
  const back = sub(observer.position, center);
  const distance = (CLEARANCE * length(sub(box.max, box.min))) / 2 + LEAST_CLEARANCE;
  return addScaled(center, normalize(back, [0, 0, 1]), Math.min(distance, length(back)));
}
