import { addScaled, dot, length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import { properVelocity, velocity } from '../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';

/** The fastest velocity that the panel's slider gives, in units of c. */
export const MAX_BETA = 0.99;

/** A separation from the observer's event, world frame: cΔt [m], Δx [m]. */
export interface Separation {
  readonly ct: number;
  readonly x: Vec3;
}

/** The observer's event after a displacement, times a factor. c [m/s]. */
export const movedBy = (
  { t, position }: Pick<ObserverState, 't' | 'position'>,
  { ct, x }: Separation,
  factor: number,
  c: number,
): Pick<ObserverState, 't' | 'position'> => ({
  t: t + (factor * ct) / c,
  position: addScaled(position, x, factor),
});

/** γβ of a velocity along an axis, β within ± `MAX_BETA`. */
export const alongAxis = (axis: Vec3, beta: number): Vec3 =>
  properVelocity(scale(axis, Math.max(-MAX_BETA, Math.min(MAX_BETA, beta))));

/** β of a velocity along an axis. */
export const betaAlong = (axis: Vec3, u: Vec3): number => dot(velocity(u), axis);

/**
 * The axis for an observer with γβ: the same as before while he moves along it, forwards or backwards, so that its sense
 * stays; else his direction. Undefined at rest without one before.
 */
export function keptAxis(before: Vec3 | undefined, u: Vec3): Vec3 | undefined {
  const speed = length(u);
  if (speed === 0) return before;
  const direction = scale(u, 1 / speed);
  const cosine = before ? dot(before, direction) : 0;
  if (Math.abs(cosine) > 1 - 1e-9) return before;
  return before && cosine < 0 ? negate(direction) : direction;
}
