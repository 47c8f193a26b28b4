import type { FrameSpacing } from '../spacing.ts';
import type { FlightPlayback } from './playback.ts';

/** A clock that shows 0 at the beginning of a flight, by which the frames of its film follow each other. */
export interface FilmClock {
  /** What it shows at the end [s]. */
  readonly duration: number;
  /** The pilot's time [s] at which it shows a time [s]. */
  readonly pilotTime: (shown: number) => number;
}

/** The pilot's clock, or the world's; undefined where world time stands still or goes back. */
export function filmClock(playback: FlightPlayback, spacing: FrameSpacing): FilmClock | undefined {
  if (spacing === 'proper') return { duration: playback.duration, pilotTime: (shown) => shown };
  const span = playback.worldSpan();
  if (!span) return undefined;
  const [from, to] = span;
  return { duration: to - from, pilotTime: (shown) => playback.timeAtWorld(from + shown) };
}
