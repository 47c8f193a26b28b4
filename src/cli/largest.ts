import type { Size } from '../nodes/drawing/painter.ts';
import { unavailable } from './exit.ts';

/** What a GPU cannot draw is refused before it comes out blank. `largest`: the most pixels of a side. */
export function refuseLarger({ width, height }: Size, largest: number): void {
  if (Math.max(width, height) > largest)
    throw unavailable(`pictures of this GPU are at most ${largest} pixels wide and high, not ${width} × ${height}`);
}
