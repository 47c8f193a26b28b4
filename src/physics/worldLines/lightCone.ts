import { add, dot, length, sub, type Vec3 } from '../../math/vec3.ts';
import type { RetardedEvent } from './emission.ts';
import type { ObserverEvent } from './kinds/worldLineKind.ts';
import { positionAt, velocityAt, type WorldLine, worldLineKind } from './worldLine.ts';

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
 * @example
 * const line: WorldLine = { kind: 'static', position: [3, 4, 0] };
 * pastLightCone(line, { t: 0, position: [0, 0, 0] }, 10); // { offset: [3, 4, 0], delay: 5 } m
 */
export const pastLightCone = (w: WorldLine, observer: ObserverEvent, c: number): RetardedEvent | undefined =>
  worldLineKind(w).pastLightCone(w, observer, c);

/**
 * World time t_e [s] of the event of `w` that the observer sees: |x(t_e) − x_o| = c(t_o − t_e), the retarded root.
 * undefined: behind a horizon, not visible. c [m/s]. docs/physics.md §3.1.
 * @example
 * // c = 10 m/s; it flies past at 6 m/s, 8 m away, and is abeam at t = 0: seen where it was 1 s before.
 * const line: WorldLine = { kind: 'uniform', position: [0, 8, 0], velocity: [6, 0, 0] };
 * emissionTime(line, { t: 0, position: [0, 0, 0] }, 10); // -1 s
 */
export function emissionTime(w: WorldLine, observer: ObserverEvent, c: number): number | undefined {
  const seen = pastLightCone(w, observer, c);
  return seen && observer.t - seen.delay / c;
}

/**
 * The whole emission event, or undefined behind a horizon. c [m/s].
 * @example
 * const line: WorldLine = { kind: 'uniform', position: [0, 8, 0], velocity: [6, 0, 0] };
 * emissionEvent(line, { t: 0, position: [0, 0, 0] }, 10); // { t: -1, position: [-6, 8, 0], velocity: [6, 0, 0], delay: 1 }
 */
export function emissionEvent(w: WorldLine, observer: ObserverEvent, c: number): EmissionEvent | undefined {
  const seen = pastLightCone(w, observer, c);
  if (!seen) return undefined;
  const t = observer.t - seen.delay / c;
  const position = add(observer.position, seen.offset);
  return { t, position, velocity: velocityAt(w, t, c), offset: seen.offset, delay: seen.delay / c };
}

/**
 * `emissionTime` of many world lines [s]; NaN if there is no event.
 * @example
 * const lines: WorldLine[] = [
 *   { kind: 'static', position: [5, 0, 0] },
 *   { kind: 'uniform', position: [0, 8, 0], velocity: [6, 0, 0] },
 * ];
 * emissionTimes(lines, { t: 0, position: [0, 0, 0] }, 10); // [-0.5, -1] s
 */
export function emissionTimes(
  lines: readonly WorldLine[],
  observer: ObserverEvent,
  c: number,
  out = new Float64Array(lines.length),
): Float64Array {
  for (let i = 0; i < lines.length; i++) out[i] = emissionTime(lines[i], observer, c) ?? Number.NaN;
  return out;
}

/**
 * Δx of many world lines, observer → emission event, 3 numbers each [m]; NaN if there is no event.
 * @example
 * const lines: WorldLine[] = [{ kind: 'uniform', position: [0, 8, 0], velocity: [6, 0, 0] }];
 * emissionOffsets(lines, { t: 0, position: [0, 0, 0] }, 10); // [-6, 8, 0] m
 */
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

/** Of the iterations that `newtonEmissionTime` and `newtonSimultaneousTime` make. */
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
 * @example
 * const line: WorldLine = { kind: 'uniform', position: [0, 8, 0], velocity: [6, 0, 0] };
 * const observer = { t: 0, position: [0, 0, 0] } as const;
 * newtonEmissionTime(line, observer, 10, { iterations: 1, damping: 1 }); // -0.8 s
 * newtonEmissionTime(line, observer, 10, { iterations: 5, damping: 1 }); // -1.000 s
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
