import type { Scene } from '../types.ts';
import { type Flight, fly } from './fly.ts';
import { retime, type Timing } from './retime.ts';

/** Changes to the motion of a file's scene; plain data. */
export interface MotionChange {
  readonly timing: Timing;
  /** Applied in order. */
  readonly flights: readonly Flight[];
}

/** The scene retimed, and then with the flights. c [m/s]. */
export const changeMotion = (scene: Scene, { timing, flights }: MotionChange, c: number): Scene =>
  flights.reduce((before, flight) => fly(before, flight, c), retime(scene, timing));
