import { encode } from 'fast-png';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/**
 * PNG of 8-bit RGBA, rows from the top, alpha not premultiplied. Throws where there are not 4 bytes for each pixel.
 * @example
 * // A red pixel.
 * encodePng(1, 1, new Uint8Array([255, 0, 0, 255])).subarray(1, 4); // [80, 78, 71]: "PNG"
 */
export function encodePng(width: number, height: number, rgba: Uint8Array | Uint8ClampedArray): Uint8Array {
  if (rgba.length !== width * height * 4) {
    throw new MessageError(
      msg`a picture of ${width} × ${height} has ${width * height * 4} bytes of RGBA, not ${rgba.length}`,
    );
  }
  return encode({ width, height, data: rgba, channels: 4, depth: 8 });
}
