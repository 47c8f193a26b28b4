import { conjugate, multiply, normalizeQuat, type Quat } from '../../math/quat.ts';
import { addScaled, length, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma, inverseBoostSpatial } from './boost.ts';
import { addVelocities, wignerRotation } from './velocity.ts';

/** An observer at one event of his world line. */
export interface ObserverState {
  /** World time [s]. */
  readonly t: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** γβ, world frame. */
  readonly u: Vec3;
  /** Camera axes in the world's axes carried by the pure boost with u: v_observer = orientation · v_camera. */
  readonly orientation: Quat;
  /** What the observer's own clock shows [s]. */
  readonly properTime: number;
}

/** sinh(x)/x, 1 at 0. */
const sinhc = (x: number): number => (x === 0 ? 1 : Math.sinh(x) / x);

/**
 * Constant proper acceleration over Δτ, exactly: with ζ = aΔτ/c the observer ends, in the frame where he began at rest, at
 * (ct, x) = (c²/a)(sinh ζ, (cosh ζ − 1) â) with u = sinh ζ â; the axes are Fermi–Walker carried (a gyroscope's), so the
 * orientation turns back by the Wigner rotation of Λ = B(tanh ζ â) B(β₀) = R·B(β_f).
 * properAcceleration [m/s²]: observer's frame (world axes carried by the pure boost), fixed in a gyroscope's axes during the step.
 * dTau [s], also negative. docs/physics.md §2.7; Misner, Thorne & Wheeler §6.2.
 */
export function accelerate(state: ObserverState, properAcceleration: Vec3, dTau: number, c: number): ObserverState {
  const zeta = (length(properAcceleration) * dTau) / c;
  const gained = scale(properAcceleration, (dTau / c) * sinhc(zeta));
  const half = sinhc(zeta / 2);
  // (c²/a)(cosh ζ − 1) â = a Δτ²/2 · sinhc²(ζ/2); the straight proper time between the ends is Δτ · sinhc(ζ/2).
  const moved = scale(properAcceleration, (dTau * dTau * half * half) / 2);
  const straight = c * Math.abs(dTau) * half;
  return displaced(state, moved, straight, gained, dTau, c);
}

/** The state after a displacement given in the frame where the observer began: its space part, its invariant length [m]. */
function displaced(
  state: ObserverState,
  moved: Vec3,
  straight: number,
  gained: Vec3,
  dTau: number,
  c: number,
): ObserverState {
  const forward = dTau < 0 ? -1 : 1;
  // A displacement into the past is minus one into the future.
  const dx = scale(inverseBoostSpatial(scale(moved, forward), straight, state.u), forward);
  return {
    t: state.t + (forward * Math.hypot(straight, dx[0], dx[1], dx[2])) / c,
    position: addScaled(state.position, dx, 1),
    u: addVelocities(state.u, gained),
    orientation: normalizeQuat(multiply(conjugate(wignerRotation(state.u, gained)), state.orientation)),
    properTime: state.properTime + dTau,
  };
}

/** Free flight over the proper time dTau [s]: t grows by γΔτ, x by u c Δτ. c [m/s]. */
export const coast = (state: ObserverState, dTau: number, c: number): ObserverState => ({
  ...state,
  t: state.t + gamma(state.u) * dTau,
  position: addScaled(state.position, state.u, c * dTau),
  properTime: state.properTime + dTau,
});
