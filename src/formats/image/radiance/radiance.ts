import { fromHalf, toHalf } from '../../../math/half.ts';
import { listed, msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { type ExrChannel, type ExrImage, writeExr } from '../exr.ts';
import { imageKind } from '../imageKind.ts';
import { readExr } from '../readExr.ts';
import { checkRadianceSize, type DecodedRadiance, storeRadiance } from './radianceLimits.ts';
import { readHdr } from './readHdr.ts';

/** A Radiance or OpenEXR picture by its content; undefined where it is neither. Throws an InputError that names `name` where it cannot be read. */
export function decodeRadiance(bytes: Uint8Array, name: string): DecodedRadiance | undefined {
  const kind = imageKind(bytes);
  if (kind === 'Radiance HDR') return readHdr(bytes, name);
  return kind === 'OpenEXR' ? radianceFromExr(readExr(bytes, name, checkRadianceSize), name) : undefined;
}

/** Its R, G and B, or Y for all three; what is negative or no number is 0. */
function radianceFromExr({ width, height, channels }: ExrImage, name: string): DecodedRadiance {
  const find = (wanted: string): ExrChannel | undefined => channels.find((c) => c.name === wanted);
  const found = [find('R') ?? find('Y'), find('G') ?? find('Y'), find('B') ?? find('Y')];
  if (found.includes(undefined)) {
    const names = channels.slice(0, 8).map((c) => c.name);
    throw inputError(
      'image.unsupported',
      name,
      msg`an EXR without channels R, G, B or Y is not read; it has ${listed(names)}`,
    );
  }
  const data = new Uint16Array(4 * width * height).fill(toHalf(1));
  const [red, green, blue] = found.map((channel) => channel!.data);
  const atLeastZero = (value: number): number => Math.max(value || 0, 0);
  for (let i = 0; i < width * height; i++)
    storeRadiance(data, 4 * i, atLeastZero(red[i]), atLeastZero(green[i]), atLeastZero(blue[i]));
  return { width, height, data };
}

/** As an EXR of halves. */
export function encodeRadiance({ width, height, data }: DecodedRadiance): Uint8Array {
  const channels = ['R', 'G', 'B'].map((name, k) => ({
    name,
    type: 'half' as const,
    data: Float32Array.from({ length: width * height }, (_, i) => fromHalf(data[4 * i + k])),
  }));
  return writeExr({ width, height, channels });
}
