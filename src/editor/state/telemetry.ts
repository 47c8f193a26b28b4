import { createStore } from 'zustand/vanilla';
import { length } from '../../math/vec3.ts';
import { gamma } from '../../physics/lorentz/boost.ts';
import type { ObserverState } from '../../physics/lorentz/observer.ts';

/** What the instruments show; renewed a few times a second, so that a page full of text does not redraw at every frame. */
export interface Telemetry {
  /** World time [s]. */
  readonly t: number;
  /** The observer's own clock [s]. */
  readonly properTime: number;
  /** |β| */
  readonly beta: number;
  readonly gamma: number;
  readonly triangles: number;
  /** How far what is drawn may be from what is seen [px]. */
  readonly tolerance: number;
  /** What is to be seen next is still being read. */
  readonly waiting: boolean;
  /** What is to be seen next needs shaders that are being compiled. */
  readonly preparing: boolean;
}

const INTERVAL = 100; // [ms]

export const telemetry = createStore<Telemetry>(() => ({
  t: 0,
  properTime: 0,
  beta: 0,
  gamma: 1,
  triangles: 0,
  tolerance: 0,
  waiting: false,
  preparing: false,
}));

let lastUpdate = Number.NEGATIVE_INFINITY;

/** `now` [ms] is the frame's time stamp. What changed too recently is shown with a later frame. */
export function updateTelemetry(
  state: ObserverState,
  drawn: Pick<Telemetry, 'triangles' | 'tolerance' | 'waiting' | 'preparing'>,
  now: number,
): void {
  if (now - lastUpdate < INTERVAL) return;
  lastUpdate = now;
  const g = gamma(state.u);
  const { triangles, tolerance, waiting, preparing } = drawn;
  const picture = { triangles, tolerance, waiting, preparing };
  const next = { t: state.t, properTime: state.properTime, beta: length(state.u) / g, gamma: g, ...picture };
  const shown = telemetry.getState();
  if ((Object.keys(next) as (keyof Telemetry)[]).some((key) => next[key] !== shown[key])) telemetry.setState(next);
}
