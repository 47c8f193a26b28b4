import { toHalf } from '../../../math/half.ts';
import { msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';

/** A picture of radiance: RGBA halves of linear sRGB, alpha 1, rows from the top. */
export interface DecodedRadiance {
  readonly width: number;
  readonly height: number;
  readonly data: Uint16Array;
}

/** Largest side and area [pixels]: 32 Mi pixels are 256 MiB. */
const MAX_SIDE = 8192;
const MAX_PIXELS = 2 ** 25;
/** The largest half. */
const MAX_RADIANCE = 65504;

/** Writes a pixel's halves; what is brighter than they hold is dimmed as a whole, so that it keeps its hue. */
export function storeRadiance(data: Uint16Array, at: number, red: number, green: number, blue: number): void {
  const scale = Math.min(1, MAX_RADIANCE / Math.min(Math.max(red, green, blue), Number.MAX_VALUE));
  data[at] = toHalf(Math.min(red * scale, MAX_RADIANCE));
  data[at + 1] = toHalf(Math.min(green * scale, MAX_RADIANCE));
  data[at + 2] = toHalf(Math.min(blue * scale, MAX_RADIANCE));
}

/** Refuses what is more than is read. */
export function checkRadianceSize(width: number, height: number, name: string): void {
  if (width > 0 && height > 0 && width <= MAX_SIDE && height <= MAX_SIDE && width * height <= MAX_PIXELS) return;
  const limit = msg`1 to ${MAX_SIDE} a side and at most ${MAX_PIXELS / 2 ** 20} Mi pixels are read of such pictures`;
  throw inputError('image.size', name, msg`the picture is ${width} × ${height} pixels, ${limit}; scale it`);
}
