import type { StoredFile } from '../streaming/storedNumbers.ts';
import type { FisheyeLens } from '../view/lenses/fisheyeLens.ts';
import type { SphericalPicture } from '../view/sphericalPicture.ts';

/** The frames of a film in a file; plain data. */
export interface FilmTrack {
  /** Where it is. */
  readonly file: StoredFile;
  /** Size of the file [bytes]. */
  readonly bytes: number;
  /** Width of a frame as it is decoded [px]. */
  readonly width: number;
  /** Height of a frame as it is decoded [px]. */
  readonly height: number;
  /** When each frame begins, rising, by the clock of the file [s]. */
  readonly times: Float64Array;
  /** When the last one ends, by the same clock [s]. */
  readonly end: number;
}

/** How each frame of a film shows the directions; absent parts: the whole sphere, by the frame's shape. */
export interface FilmLayout {
  /** A circle in the middle of the frame. */
  readonly fisheye?: FisheyeLens;
  /** What the file says of it. */
  readonly coverage?: SphericalPicture;
}

/**
 * A film of surroundings at infinity, taken at rest at the origin of the world. Its light is plane waves: the frame that reaches an event (t, x) from the
 * direction n was in the origin at t + n·x/c. docs/physics.md §6.12.
 */
export interface DomeFilm {
  /** Its frames. */
  readonly track: FilmTrack;
  /** How they show the directions. */
  readonly layout: FilmLayout;
  /** World time at which its first frame is in the origin [s]. */
  readonly start: number;
  /** Seconds of the film per second of world time; above 0. */
  readonly speed: number;
  /** Whether it begins again when it has ended, and has gone on before it began; otherwise its first and last frame stay. */
  readonly repeats: boolean;
}

/** Rounding of times [s] must not show the frame before. */
const ROUNDING = 1e-9;

/** How long it lasts, in world time [s]. */
export const filmDuration = ({ track: { times, end }, speed }: DomeFilm): number => (end - times[0]!) / speed;

/** The index of the frame that is in the origin at a world time [s]. */
export function frameAt(film: DomeFilm, time: number): number {
  const { times, end } = film.track;
  const duration = end - times[0]!;
  const played = (time - film.start) * film.speed;
  const shown = film.repeats ? played - Math.floor((played + ROUNDING) / duration) * duration : played;
  return lastBefore(times, times[0]! + shown);
}

/** The index of the last time that is not after `time`; 0 if all are. */
export function lastBefore(times: Float64Array, time: number): number {
  const reached = time + ROUNDING * Math.max(1, Math.abs(time));
  let [low, high] = [0, times.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= reached) low = middle;
    else high = middle;
  }
  return low;
}
