import { add, dot, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../lorentz/boost.ts';
import { cubicEmission } from './cubicPiece.ts';
import {
  circularEmission,
  hyperbolicEmission,
  polylineEmission,
  presentEmission,
  type RetardedEvent,
  staticEmission,
} from './emission.ts';
import {
  type CubicLine,
  circleAt,
  firstAfter,
  type PolylineLine,
  positionAt,
  relativePiece,
  samplePosition,
  velocityAt,
  type WorldLine,
} from './worldLine.ts';

/** The observer's event, in the world frame. */
export interface ObserverEvent {
  /** World time [s]. */
  readonly t: number;
  /** [m] */
  readonly position: Vec3;
}

/** The event of a world line whose light reaches the observer's event. */
export interface EmissionEvent {
  /** World time t_e [s]. */
  readonly t: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** World frame [m/s]. */
  readonly velocity: Vec3;
  /** Δx: observer → emission event [m]; more accurate than the difference of two large positions. */
  readonly offset: Vec3;
  /** t_o − t_e ≥ 0 [s]; more accurate than the difference of two large times. */
  readonly delay: number;
}

/**
 * The emission event in relative form, in metres and metres of light travel, or undefined if no light of the world line reaches the
 * observer's event (hyperbolic motion behind its horizon). Always the retarded root. docs/physics.md §3.1.
 */
export function pastLightCone(w: WorldLine, observer: ObserverEvent, c: number): RetardedEvent | undefined {
  const { t, position } = observer;
  switch (w.kind) {
    case 'static':
      return staticEmission(sub(w.position, position));
    case 'uniform': {
      const v = scale(w.velocity, 1 / c);
      return presentEmission(sub(positionAt(w, t, c), position), v, oneMinusBetaSquared(v));
    }
    case 'hyperbolic':
      return hyperbolicEmission(sub(w.position, position), c * (t - w.t0), scale(w.properAcceleration, 1 / (c * c)));
    case 'circular': {
      const { center, arm } = circleAt(w, t);
      return circularEmission(sub(center, position), w.axis, arm, w.angularVelocity / c);
    }
    case 'polyline':
    case 'cubic':
      return sampledEmission(w, observer, c);
  }
}

/** f(t) = |x(t) − x_o| − c(t_o − t) increases while the speed is below c, so bisection on its sign at the samples finds the piece (docs/physics.md §4.7). */
function sampledEmission(w: PolylineLine | CubicLine, { t, position }: ObserverEvent, c: number): RetardedEvent {
  const offset = (i: number) => sub(samplePosition(w, i), position);
  const time = (i: number) => c * (w.times[i] - t);
  const after = firstAfter(w.times.length, (i) => length(offset(i)) + time(i) <= 0);
  if (after === 0) return staticEmission(offset(0));
  if (after === w.times.length) return staticEmission(offset(after - 1));
  if (w.kind === 'cubic') return cubicEmission(relativePiece(w, after - 1, position, c), time(after - 1));
  return polylineEmission(offset(after - 1), time(after - 1), offset(after), time(after));
}

/**
 * World time t_e [s] of the event of `w` that the observer sees: |x(t_e) − x_o| = c(t_o − t_e), the retarded root.
 * undefined: behind a horizon, not visible. c [m/s]. docs/physics.md §3.1.
 */
export function emissionTime(w: WorldLine, observer: ObserverEvent, c: number): number | undefined {
  const seen = pastLightCone(w, observer, c);
  return seen && observer.t - seen.delay / c;
}

/** The whole emission event, or undefined behind a horizon. c [m/s]. */
export function emissionEvent(w: WorldLine, observer: ObserverEvent, c: number): EmissionEvent | undefined {
  const seen = pastLightCone(w, observer, c);
  if (!seen) return undefined;
  const t = observer.t - seen.delay / c;
  const position = add(observer.position, seen.offset);
  return { t, position, velocity: velocityAt(w, t, c), offset: seen.offset, delay: seen.delay / c };
}

/** `emissionTime` of many world lines [s]; NaN if there is no event. */
export function emissionTimes(
  lines: readonly WorldLine[],
  observer: ObserverEvent,
  c: number,
  out = new Float64Array(lines.length),
): Float64Array {
  for (let i = 0; i < lines.length; i++) out[i] = emissionTime(lines[i], observer, c) ?? Number.NaN;
  return out;
}

/** Δx of many world lines, observer → emission event, 3 numbers each [m]; NaN if there is no event. */
export function emissionOffsets(
  lines: readonly WorldLine[],
  observer: ObserverEvent,
  c: number,
  out = new Float64Array(3 * lines.length),
): Float64Array {
  for (let i = 0; i < lines.length; i++)
    out.set(pastLightCone(lines[i], observer, c)?.offset ?? [Number.NaN, Number.NaN, Number.NaN], 3 * i);
  return out;
}

export interface NewtonOptions {
  /** Number of steps. */
  readonly iterations: number;
  /** k in the step −k f/f′, 0 < k ≤ 1. */
  readonly damping: number;
}

/**
 * Damped Newton iteration t ← t − k f/f′, started at t_o, for comparison with `emissionTime`:
 * f = |x(t) − x_o| − c(t_o − t), f′ = (x − x_o)·v/|x − x_o| + c. World time after the last step [s].
 * docs/physics.md §4.11.
 */
export function newtonEmissionTime(w: WorldLine, observer: ObserverEvent, c: number, options: NewtonOptions): number {
  let t = observer.t;
  for (let i = 0; i < options.iterations; i++) {
    const d = sub(positionAt(w, t, c), observer.position);
    const r = length(d);
    const slope = c + (r > 0 ? dot(d, velocityAt(w, t, c)) / r : 0);
    t -= (options.damping * (r - c * (observer.t - t))) / slope;
  }
  return t;
}
