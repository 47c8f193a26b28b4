import type { Vec3 } from '../../math/vec3.ts';
import { decodeSrgb, encodeSrgb } from '../../spectrum/srgb.ts';
import type { DecodedImage } from '../images.ts';

/** How an input reads a picture: value = texel · scale + bias, each in four channels; `channels`: which one each colour takes. */
export interface TexelReading {
  readonly scale: readonly number[];
  readonly bias: readonly number[];
  readonly channels: readonly [number, number, number];
  readonly colorSpace: 'srgb' | 'linear';
}

/** A picture whose texels times `gain` are what is read. */
export interface Adjusted {
  readonly image: DecodedImage;
  readonly gain: Vec3;
}

/** The colours that an input reads; the picture itself where it can be had by a factor. Alpha stays. */
export function adjustedColor(image: DecodedImage, reading: TexelReading): Adjusted {
  const { scale, bias, channels, colorSpace } = reading;
  const plain = channels.every((from, k) => from === k && bias[k] === 0 && scale[k] >= 0);
  if (plain) return { image, gain: [scale[0], scale[1], scale[2]] };
  const decoded = channels.map((from) => valuesOf(from, reading));
  const gain = decoded.map((values) => Math.max(...values, 1e-6));
  const tables = decoded.map((values, k) =>
    Uint8Array.from(values, (x) => Math.round(255 * (colorSpace === 'srgb' ? encodeSrgb(x / gain[k]) : x / gain[k]))),
  );
  const data = image.data.slice();
  for (let i = 0; i < data.length; i += 4)
    for (let k = 0; k < 3; k++) data[i + k] = tables[k][image.data[i + channels[k]]];
  return { image: { ...image, data }, gain: [gain[0], gain[1], gain[2]] };
}

/** Opacity from one channel, as the picture's alpha; `gain` is at most 1, as opacities are. */
export function adjustedAlpha(
  image: DecodedImage,
  channel: number,
  reading: TexelReading,
): { image: DecodedImage; channel: number; gain: number } {
  const scale = reading.scale[channel];
  const linear = channel === 3 || reading.colorSpace === 'linear';
  if (linear && reading.bias[channel] === 0 && scale >= 0 && scale <= 1) return { image, channel, gain: scale };
  const table = Uint8Array.from(valuesOf(channel, reading), (x) => Math.round(255 * Math.min(x, 1)));
  const data = image.data.slice();
  for (let i = 0; i < data.length; i += 4) data[i + 3] = table[image.data[i + channel]];
  return { image: { ...image, data }, channel: 3, gain: 1 };
}

/** Mean of what is read from a channel. */
export function adjustedMean(image: DecodedImage, channel: number, reading: TexelReading): number {
  const table = valuesOf(channel, reading);
  let sum = 0;
  for (let i = channel; i < image.data.length; i += 4) sum += table[image.data[i]];
  return sum / (image.width * image.height);
}

/** Byte → value, 0 or more; alpha is linear always. */
const valuesOf = (channel: number, { scale, bias, colorSpace }: TexelReading): number[] =>
  Array.from({ length: 256 }, (_, byte) => {
    const texel = colorSpace === 'srgb' && channel < 3 ? decodeSrgb(byte / 255) : byte / 255;
    return Math.max(0, texel * scale[channel] + bias[channel]);
  });
