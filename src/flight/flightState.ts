import { multiply, normalizeQuat, type Quat } from '../math/quat.ts';
import { plus, type Sum, sumOf } from '../math/sum.ts';
import { addScaled, dot, scale, type Vec3 } from '../math/vec3.ts';
import type { ObserverState } from '../physics/lorentz/observer.ts';
import { type Boost, bearing, boostOf, compose, gyroscopeRotation, properVelocityOf } from './boost.ts';

/** An observer in flight, at one event of its world line. What adds up over a flight is a compensated sum. */
export interface FlightState {
  /** World time [s]. */
  readonly t: Sum;
  /** World frame [m]. */
  readonly position: readonly [x: Sum, y: Sum, z: Sum];
  /** World frame. */
  readonly velocity: Boost;
  /** Camera axes, relative to the world's axes carried by the pure boost: v_observer = orientation · v_camera. */
  readonly orientation: Quat;
  /** Reading of the observer's own clock [s]. */
  readonly properTime: Sum;
}

/** Proper acceleration in the observer's axes (the world's, carried by the pure boost). */
export interface ProperAcceleration {
  /** Of length 1. */
  readonly direction: Vec3;
  /** ≥ 0 [m/s²] */
  readonly size: number;
}

export const flightOf = ({ t, position: [x, y, z], u, orientation, properTime }: ObserverState): FlightState => ({
  t: sumOf(t),
  position: [sumOf(x), sumOf(y), sumOf(z)],
  velocity: boostOf(u),
  orientation,
  properTime: sumOf(properTime),
});

export const observerOf = ({ t, position: [x, y, z], velocity, ...state }: FlightState): ObserverState => ({
  t: t.value,
  position: [x.value, y.value, z.value],
  u: properVelocityOf(velocity),
  orientation: state.orientation,
  properTime: state.properTime.value,
});

/** Pictures are drawn up to this γ: beyond it, directions ahead differ by less than the 32 bits of a GPU hold. */
export const MAX_PICTURE_GAMMA = 1e4;

/** The proper velocity with which a picture is drawn. */
export const pictureVelocity = ({ direction, rapidity }: Boost): Vec3 =>
  properVelocityOf({ direction, rapidity: Math.min(rapidity, Math.acosh(MAX_PICTURE_GAMMA)) });

/** The position after a displacement [m]. */
export const shifted = ([x, y, z]: FlightState['position'], by: Vec3): FlightState['position'] => [
  plus(x, by[0]),
  plus(y, by[1]),
  plus(z, by[2]),
];

/** sinh(x)/x, 1 at 0. */
const sinhc = (x: number): number => (x === 0 ? 1 : Math.sinh(x) / x);

/**
 * The state after the proper time Δτ ≥ 0 [s] at constant proper acceleration a, exactly. With δ = aΔτ/c, at the angle θ to
 * the motion n̂ of rapidity φ, and the straight line between the ends s = cΔτ sinh(δ/2)/(δ/2):
 *
 *     cΔt = s [cosh(φ − δ/2) + 2 sinh φ sinh(δ/2) cos²(θ/2)]
 *     Δx  = s [sinh(φ − δ/2) + 2 cosh φ sinh(δ/2) cos²(θ/2)] n̂ + s sinh(δ/2) (â − (â·n̂) n̂)
 *
 * which is the hyperbola ΔX = Λ⁻¹(c²/a)(sinh δ, (cosh δ − 1) â) without its cancellations where it brakes. Axes are
 * Fermi–Walker transported, as a gyroscope's. c [m/s]. docs/physics.md §2.7; Misner, Thorne & Wheeler §6.2.
 */
export function accelerateFlight(
  state: FlightState,
  { direction, size }: ProperAcceleration,
  dTau: number,
  c: number,
): FlightState {
  const gained: Boost = { direction, rapidity: (size * dTau) / c };
  const { direction: n, rapidity: phi } = state.velocity;
  const { cosHalfSquared, across } = bearing(n, direction);
  const half = gained.rapidity / 2;
  const straight = c * dTau * sinhc(half);
  const turned = 2 * Math.sinh(half) * cosHalfSquared;
  const time = straight * (Math.cosh(phi - half) + Math.sinh(phi) * turned);
  const along = straight * (Math.sinh(phi - half) + Math.cosh(phi) * turned);
  return {
    t: plus(state.t, time / c),
    position: shifted(state.position, addScaled(scale(n, along), across, straight * Math.sinh(half))),
    velocity: compose(state.velocity, gained),
    orientation: normalizeQuat(multiply(gyroscopeRotation(state.velocity, gained), state.orientation)),
    properTime: plus(state.properTime, dTau),
  };
}

/** ln cosh φ for φ ≥ 0, without overflow. */
const lnCosh = (phi: number): number => phi + Math.log1p(Math.exp(-2 * phi)) - Math.LN2;

/**
 * The way ∫cβ dτ [m] of one who moves by his speed in his own time, as with the lock `fly`: over Δτ [s] of constant proper
 * acceleration a from the rapidity φ to φ′, with σ = aΔτ/c and Λ = ln(cosh φ′/cosh φ),
 *
 *     c²/a {[sinh φ cosh φ sin²θ σ + cos θ Λ] n̂ + [cosh φ Λ − sinh φ cos θ σ] (â − (â·n̂) n̂)} / (1 + sinh²φ sin²θ)
 *
 * which from rest is (c²/a) ln cosh σ. c [m/s].
 */
export function wayAtSpeed(velocity: Boost, { direction, size }: ProperAcceleration, dTau: number, c: number): Vec3 {
  const { direction: n, rapidity: phi } = velocity;
  const gained = (size * dTau) / c;
  const { cosHalfSquared, across } = bearing(n, direction);
  const cos = 2 * cosHalfSquared - 1;
  const [sinh, cosh, sinSquared] = [Math.sinh(phi), Math.cosh(phi), dot(across, across)];
  // cosh φ′/cosh φ − 1 keeps its digits in a short arc, and a difference of logarithms in a long one.
  const more = 2 * Math.sinh(gained / 2) ** 2 + Math.tanh(phi) * cos * Math.sinh(gained);
  const rise =
    gained < 0.5 ? Math.log1p(more) : lnCosh(compose(velocity, { direction, rapidity: gained }).rapidity) - lnCosh(phi);
  const part = (c * c) / (size * (1 + sinh * sinh * sinSquared));
  const along = part * (sinh * cosh * sinSquared * gained + cos * rise);
  return addScaled(scale(n, along), across, part * (cosh * rise - sinh * cos * gained));
}

/** Free motion over the proper time Δτ [s]: t grows by Δτ cosh φ, x by cΔτ sinh φ n̂. c [m/s]. */
export const coastFlight = (state: FlightState, dTau: number, c: number): FlightState => ({
  ...state,
  t: plus(state.t, Math.cosh(state.velocity.rapidity) * dTau),
  position: shifted(state.position, scale(properVelocityOf(state.velocity), c * dTau)),
  properTime: plus(state.properTime, dTau),
});
