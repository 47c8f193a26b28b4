import { encode } from 'fast-png';

/** PNG of 8-bit RGBA, rows from the top, alpha not premultiplied. */
export function encodePng(width: number, height: number, rgba: Uint8Array | Uint8ClampedArray): Uint8Array {
  if (rgba.length !== width * height * 4) {
    throw new RangeError(
      `a picture of ${width} × ${height} has ${width * height * 4} bytes of RGBA, not ${rgba.length}`,
    );
  }
  return encode({ width, height, data: rgba, channels: 4, depth: 8 });
}
