import { encodeSrgb } from '../../spectrum/display/srgb.ts';
import type { Material } from '../types.ts';
import type { Texture } from './texture.ts';

/** Texels of a cell along each side, so that linear filtering blurs an eighth of it. */
const CELL = 8;

/** Two by two cells of a checkerboard, which repeat; the cell at u = v = 0 has the first colour. Linear sRGB, 0 … 1. */
export function checkerTexture(
  colors: readonly [Material['baseColor'], Material['baseColor']],
  filter: Texture['filter'],
): Texture {
  const side = 2 * CELL;
  const bytes = colors.map((color) => [
    ...color.map((x) => Math.round(255 * encodeSrgb(Math.min(Math.max(x, 0), 1)))),
    255,
  ]);
  const data = new Uint8Array(4 * side * side);
  for (let y = 0; y < side; y++)
    for (let x = 0; x < side; x++) {
      // Rows run from the top, v from below.
      const odd = x < CELL === y < CELL ? 1 : 0;
      data.set(bytes[odd]!, 4 * (y * side + x));
    }
  return {
    name: 'checker',
    width: side,
    height: side,
    data,
    colorSpace: 'srgb',
    filter,
    wrapS: 'repeat',
    wrapT: 'repeat',
  };
}
