import type { Quat } from '../../math/quat.ts';
import { addScaled, length, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { isStatic } from '../motion/motion.ts';
import type { SceneCamera } from '../types.ts';
import { observerFromCamera, riddenLine } from './camera.ts';
import type { Lens } from './lenses/lenses.ts';
import type { ViewPoint } from './view.ts';

/** The observer at world time t [s]. */
export type ObserverPath = (t: number) => ViewPoint;

/** The camera of a picture, and what overrides it. */
export interface ObserverSetup {
  readonly camera: SceneCamera;
  /** Velocity in units of c. */
  readonly beta?: Vec3;
  /** World frame [m]; replaces the camera's path. */
  readonly position?: Vec3;
  /** As in `ViewPoint`. */
  readonly orientation?: Quat;
  /** Replaces the camera's. */
  readonly lens?: Lens;
  /** Keeps the position in spite of the velocity, as the lock `look`. */
  readonly stayInPlace?: boolean;
  /** As in `ViewPoint` [m]. */
  readonly vantage?: Vec3;
}

/** Whether the observer rides on his camera: it moves, and no position replaces its path. */
export const ridesCamera = ({ camera, position }: Pick<ObserverSetup, 'camera' | 'position'>): boolean =>
  !isStatic(camera.motion) && position === undefined;

/**
 * The path of an observer who starts at world time `start` [s]; c [m/s]. He rides on a moving camera; otherwise he coasts from his position with his velocity, or
 * stays there.
 */
export function observerPathFrom(setup: ObserverSetup, c: number, start: number): ObserverPath {
  const { camera, beta, position, orientation, lens, stayInPlace, vantage } = setup;
  const moves = ridesCamera(setup);
  return (t) => {
    const carried = observerFromCamera(camera, t, c);
    const drift = moves || stayInPlace || !beta ? 0 : c * (t - start);
    return {
      t,
      position: addScaled(position ?? carried.position, beta ?? ZERO, drift),
      u: beta ? properVelocity(beta) : moves ? carried.u : ZERO,
      orientation: orientation ?? carried.orientation,
      lens: lens ?? carried.lens,
      ...(vantage && { vantage }),
    };
  };
}

/**
 * The world line along which the observer of a setup carries his clock, up to its place; undefined for one who is at rest, or whose velocity is not
 * that of his path: he stays in place, or rides with a velocity that is not the camera's.
 */
export function observerWorldLine(setup: ObserverSetup, c: number): WorldLine | undefined {
  const { camera, beta, stayInPlace } = setup;
  if (ridesCamera(setup)) return beta ? undefined : riddenLine(camera);
  if (stayInPlace || !beta || length(beta) === 0) return undefined;
  return { kind: 'uniform', position: ZERO, velocity: scale(beta, c) };
}
