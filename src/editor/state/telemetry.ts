import { createStore } from 'zustand/vanilla';
import { length } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';
import type { Shading } from '../../render/settings.ts';

/** Values of the instruments, updated a few times a second, so that the page does not re-render at every frame. */
export interface Telemetry {
  /** World time [s]. */
  readonly t: number;
  /** Proper time of the observer [s]. */
  readonly properTime: number;
  /** |β| */
  readonly beta: number;
  readonly gamma: number;
  readonly triangles: number;
  /** Error bound of the displayed picture [px]. */
  readonly tolerance: number;
  readonly shading: Shading;
  /** Whether there is a picture of this scene. */
  readonly drawn: boolean;
  /** Whether the next picture waits for samples that are being read. */
  readonly waiting: boolean;
  /** Whether the next picture waits for shaders that are being compiled. */
  readonly preparing: boolean;
  /** Whether the observer has left the scene. */
  readonly outside: boolean;
}

const INTERVAL = 100; // [ms]

export const telemetry = createStore<Telemetry>(() => ({
  t: 0,
  properTime: 0,
  beta: 0,
  gamma: 1,
  triangles: 0,
  tolerance: 0,
  shading: 'deferred',
  drawn: false,
  waiting: false,
  preparing: false,
  outside: false,
}));

let lastUpdate = Number.NEGATIVE_INFINITY;

/** `now` [ms] is the frame's time stamp. Changes within the interval are published with a later frame. */
export function updateTelemetry(
  state: ObserverState,
  picture: Omit<Telemetry, 't' | 'properTime' | 'beta' | 'gamma'>,
  now: number,
): void {
  if (now - lastUpdate < INTERVAL) return;
  lastUpdate = now;
  const g = gamma(state.u);
  const observed = { t: state.t, properTime: state.properTime, beta: length(state.u) / g, gamma: g };
  const next: Telemetry = { ...observed, ...picture };
  const shown = telemetry.getState();
  if ((Object.keys(next) as (keyof Telemetry)[]).some((key) => next[key] !== shown[key])) telemetry.setState(next);
}
