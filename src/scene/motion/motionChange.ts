import type { Scene } from '../types.ts';
import { type Flight, fly } from './fly.ts';
import { retime, type Timing } from './retime.ts';

/** How the motion of a scene differs from its file's; plain data. */
export interface MotionChange {
  readonly timing: Timing;
  /** One after another. */
  readonly flights: readonly Flight[];
}

/** The scene with its animation run otherwise, and then what is to fly flying. c [m/s]. */
export const changeMotion = (scene: Scene, { timing, flights }: MotionChange, c: number): Scene =>
  flights.reduce((before, flight) => fly(before, flight, c), retime(scene, timing));
