import { conjugate, multiply, normalizeQuat, type Quat } from '../../math/quat.ts';
import { addScaled, length, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma, inverseBoostSpatial } from './boost.ts';
import { addVelocities, wignerRotation } from './velocity.ts';

/** An observer at one event of its world line. */
export interface ObserverState {
  /** World time [s]. */
  readonly t: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** γβ, world frame. */
  readonly u: Vec3;
  /** Camera axes, relative to the world's axes carried by the pure boost with u: v_observer = orientation · v_camera. */
  readonly orientation: Quat;
  /** Reading of the observer's own clock [s]. */
  readonly properTime: number;
}

/** sinh(x)/x, 1 at 0. */
const sinhc = (x: number): number => (x === 0 ? 1 : Math.sinh(x) / x);

/**
 * The state after the proper time Δτ at constant proper acceleration, exactly: with ζ = aΔτ/c the observer ends, in the frame where it was at rest
 * at the beginning, at (ct, x) = (c²/a)(sinh ζ, (cosh ζ − 1) â) with u = sinh ζ â. The axes are Fermi–Walker transported (as a gyroscope's), so
 * the orientation is rotated by the inverse Wigner rotation of Λ = B(tanh ζ â) B(β₀) = R·B(β_f).
 * properAcceleration [m/s²]: observer's frame (world axes carried by the pure boost), constant in gyroscope axes during the step.
 * dTau [s], also negative. docs/physics.md §2.7; Misner, Thorne & Wheeler §6.2.
 * @example
 * // One year of 1 g, in years and light-years: c = 1, g = 1.0323 ly/a².
 * const atRest: ObserverState = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: [0, 0, 0, 1], properTime: 0 };
 * const after = accelerate(atRest, [0, 0, 1.0323], 1, 1);
 * after.t; // 1.187 a: sinh(1.0323)/1.0323
 * velocity(after.u); // [0, 0, 0.7748] c: tanh 1.0323
 */
export function accelerate(state: ObserverState, properAcceleration: Vec3, dTau: number, c: number): ObserverState {
  const zeta = (length(properAcceleration) * dTau) / c;
  const gained = scale(properAcceleration, (dTau / c) * sinhc(zeta));
  const half = sinhc(zeta / 2);
  // (c²/a)(cosh ζ − 1) â = a Δτ²/2 · sinhc²(ζ/2); the proper time of the straight line between the ends is Δτ · sinhc(ζ/2).
  const moved = scale(properAcceleration, (dTau * dTau * half * half) / 2);
  const straight = c * Math.abs(dTau) * half;
  return displaced(state, moved, straight, gained, dTau, c);
}

/** The state after a displacement given in the initial rest frame: its spatial part `moved` and its invariant length `straight` [m]. */
function displaced(
  state: ObserverState,
  moved: Vec3,
  straight: number,
  gained: Vec3,
  dTau: number,
  c: number,
): ObserverState {
  const forward = dTau < 0 ? -1 : 1;
  // A past-directed displacement is minus a future-directed one.
  const dx = scale(inverseBoostSpatial(scale(moved, forward), straight, state.u), forward);
  return {
    t: state.t + (forward * Math.hypot(straight, dx[0], dx[1], dx[2])) / c,
    position: addScaled(state.position, dx, 1),
    u: addVelocities(state.u, gained),
    orientation: normalizeQuat(multiply(conjugate(wignerRotation(state.u, gained)), state.orientation)),
    properTime: state.properTime + dTau,
  };
}

/**
 * Free motion over the proper time dTau [s]: t grows by γΔτ, x by u c Δτ. c [m/s].
 * @example
 * // A muon at 0.8 c for 3 s of its own time, with c = 1 m/s.
 * const moving: ObserverState = { t: 0, position: [0, 0, 0], u: [4 / 3, 0, 0], orientation: [0, 0, 0, 1], properTime: 0 };
 * coast(moving, 3, 1); // { t: 5, position: [4, 0, 0], properTime: 3 }
 */
export const coast = (state: ObserverState, dTau: number, c: number): ObserverState => ({
  ...state,
  t: state.t + gamma(state.u) * dTau,
  position: addScaled(state.position, state.u, c * dTau),
  properTime: state.properTime + dTau,
});
