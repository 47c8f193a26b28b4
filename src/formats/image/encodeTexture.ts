import { encode } from 'fast-png';
import { encodePng } from './encodePng.ts';

/** A picture that is written once and read often is packed with more effort (zlib). */
const LEVEL = 9;
const MAX_COLORS = 256;

/**
 * The shortest kind of PNG of a texture, rows from the top: without alpha where all is opaque, with a palette where
 * 256 colours are enough, else as `encodePng`. The pixels are the same.
 */
export function encodeTexture(width: number, height: number, rgba: Uint8Array | Uint8ClampedArray): Uint8Array {
  if (rgba.some((x, i) => i % 4 === 3 && x < 255)) return encodePng(width, height, rgba);
  const { palette, indices } = paletteOf(rgba);
  const size = { width, height, depth: 8 } as const;
  const options = { zlib: { level: LEVEL } } as const;
  const rgb = encode({ ...size, channels: 3, data: rgba.filter((_, i) => i % 4 !== 3) }, options);
  const indexed = palette && encode({ ...size, channels: 1, palette, data: indices }, options);
  return indexed && indexed.length < rgb.length ? indexed : rgb;
}

type Rgb = [red: number, green: number, blue: number];

/** The colours in the order of their first use, and the place of each pixel's; no palette where they are too many. */
function paletteOf(rgba: Uint8Array | Uint8ClampedArray): { palette?: Rgb[]; indices: Uint8Array } {
  const places = new Map<number, number>();
  const palette: Rgb[] = [];
  const indices = new Uint8Array(rgba.length / 4);
  for (let i = 0; i < indices.length; i++) {
    const color: Rgb = [rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]];
    const key = (color[0] << 16) | (color[1] << 8) | color[2];
    const known = places.get(key);
    if (known === undefined && palette.push(color) > MAX_COLORS) return { indices };
    indices[i] = known ?? palette.length - 1;
    places.set(key, indices[i]);
  }
  return { palette, indices };
}
