import type { Quat } from '../../math/quat.ts';
import { addScaled, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { isStatic } from '../motion/motion.ts';
import type { SceneCamera } from '../types.ts';
import { observerFromCamera } from './camera.ts';
import { perspective } from './lens.ts';
import type { ViewPoint } from './view.ts';

/** The observer at world time t [s]. */
export type ObserverPath = (t: number) => ViewPoint;

/** From where a scene is looked at, and what is to be other than the camera has it. */
export interface ObserverSetup {
  readonly camera: SceneCamera;
  /** Velocity in units of c. */
  readonly beta?: Vec3;
  /** World frame [m]; the camera's path no longer counts. */
  readonly position?: Vec3;
  /** As that of a `ViewPoint`. */
  readonly orientation?: Quat;
  /** [rad] */
  readonly fovY?: number;
  /** Stays in place although there is a velocity, as the lock `look`. */
  readonly hold?: boolean;
}

/**
 * The way of an observer who starts at world time `start` [s]; c [m/s]. A camera that moves carries it along; else it coasts from its place
 * with its velocity, or holds.
 */
export function observerPathFrom(setup: ObserverSetup, c: number, start: number): ObserverPath {
  const { camera, beta, position, orientation, fovY, hold } = setup;
  const moves = !isStatic(camera.motion) && position === undefined;
  return (t) => {
    const carried = observerFromCamera(camera, t, c);
    const drift = moves || hold || !beta ? 0 : c * (t - start);
    return {
      t,
      position: addScaled(position ?? carried.position, beta ?? ZERO, drift),
      u: beta ? properVelocity(beta) : moves ? carried.u : ZERO,
      orientation: orientation ?? carried.orientation,
      lens: fovY === undefined ? carried.lens : perspective(fovY),
    };
  };
}
