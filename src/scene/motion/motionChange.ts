import type { Scene } from '../types.ts';
import { type Flight, fly } from './fly.ts';
import { retime, type Timing } from './retime.ts';

/** Changes to the motion of a file's scene; plain data. */
export interface MotionChange {
  /** How the scene is retimed. */
  readonly timing: Timing;
  /** What then flies, one after another. */
  readonly flights: readonly Flight[];
}

/**
 * The scene retimed, and then with the flights. c [m/s].
 * @example
 * const scene = makeScene({ name: 'one', endTime: 10, objects: [makeObject({ path: '/Ball', mesh: sphere(1) })] });
 * changeMotion(scene, { timing: { offset: 0, speed: 2 }, flights: [] }, 10).endTime; // 5 s
 */
export const changeMotion = (scene: Scene, { timing, flights }: MotionChange, c: number): Scene =>
  flights.reduce((before, flight) => fly(before, flight, c), retime(scene, timing));
