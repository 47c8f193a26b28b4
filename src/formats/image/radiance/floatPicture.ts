import { fromHalf } from '../../../math/half.ts';
import { listed, msg } from '../../../messages/message.ts';
import { encodeSrgb } from '../../../spectrum/display/srgb.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import type { DecodedImage } from '../decodeImage.ts';
import { hasRadiance, imageKind } from '../imageKind.ts';
import { readExr } from '../readExr.ts';
import { checkRadianceSize } from './radianceLimits.ts';
import { readHdr } from './readHdr.ts';

/** A picture of linear light as a texture has it; what is beyond 0 … 1 is cut. */
interface FloatPicture extends DecodedImage {
  /** The same pixels without the sRGB curve: for roughness, normals and the like, where a file says that it has numbers. */
  readonly numbers: Uint8Array;
}

/** Straight channels of a pixel, 0 … 1. */
type PixelChannels = readonly ((pixel: number) => number)[];

/** An OpenEXR or Radiance picture by its content, sRGB-encoded; undefined where it is neither. Throws an InputError that names `name`. */
export function decodeFloatPicture(bytes: Uint8Array, name: string): FloatPicture | undefined {
  if (!hasRadiance(bytes)) return undefined;
  const { width, height, channels } =
    imageKind(bytes) === 'OpenEXR' ? exrChannels(bytes, name) : hdrChannels(bytes, name);
  const data = new Uint8Array(4 * width * height);
  const numbers = new Uint8Array(4 * width * height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    for (const [k, channel] of channels.entries()) {
      // No number is 0.
      const value = Math.min(1, Math.max(0, channel(pixel) || 0));
      numbers[4 * pixel + k] = Math.round(255 * value);
      data[4 * pixel + k] = k === 3 ? numbers[4 * pixel + k] : Math.round(255 * encodeSrgb(value));
    }
  }
  return { width, height, data, numbers };
}

interface Channels {
  readonly width: number;
  readonly height: number;
  readonly channels: PixelChannels;
}

function hdrChannels(bytes: Uint8Array, name: string): Channels {
  const { width, height, data } = readHdr(bytes, name);
  return { width, height, channels: [0, 1, 2, 3].map((k) => (pixel) => fromHalf(data[4 * pixel + k])) };
}

/** R, G, B and A; Y, or an only channel, for all three. Colours of an EXR are multiplied with its alpha. */
function exrChannels(bytes: Uint8Array, name: string): Channels {
  const { width, height, channels } = readExr(bytes, name, checkRadianceSize);
  const find = (wanted: string) => channels.find((channel) => channel.name === wanted)?.data;
  const gray = find('Y') ?? (channels.length === 1 ? channels[0].data : undefined);
  const colors = ['R', 'G', 'B'].map((wanted) => find(wanted) ?? gray);
  const alpha = find('A');
  if (colors.includes(undefined)) {
    const names = channels.slice(0, 8).map((channel) => channel.name);
    const message = msg`an EXR without channels R, G, B or Y is not read; it has ${listed(names)}`;
    throw inputError('image.unsupported', name, message);
  }
  const straight = colors.map((values) => (pixel: number) => {
    const covered = alpha ? alpha[pixel] : 1;
    return covered > 0 && covered < 1 ? values![pixel] / covered : values![pixel];
  });
  return { width, height, channels: [...straight, (pixel) => (alpha ? alpha[pixel] : 1)] };
}
