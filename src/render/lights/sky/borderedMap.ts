import { toHalf } from '../../../math/half.ts';
import type { HalfTexels } from '../../../shaders/tables/halfAtlas.ts';
import { type Panorama, pixelOffset } from './prefilteredDome.ts';

/** Width of the wrapped border of a map in a table [px]. */
export const BORDER = 1;

/** The largest finite half-precision number. */
const MAX_HALF = 65504;

/** Writes the colours of a map with its border into a table, from a texel on. */
export function writeBordered(map: Panorama, { data, width }: HalfTexels, left: number, top: number): void {
  for (let y = 0; y < map.height + 2 * BORDER; y++)
    for (let x = 0; x < map.width + 2 * BORDER; x++) {
      const from = pixelOffset(map, y - BORDER, x - BORDER);
      const to = 4 * ((top + y) * width + left + x);
      for (let k = 0; k < 3; k++) data[to + k] = toHalf(Math.min(Math.max(map.rgb[from + k], -MAX_HALF), MAX_HALF));
    }
}
