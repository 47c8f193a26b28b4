import { normalize, type Vec3 } from '../../../../math/vec3.ts';
import type { NormalTexture } from '../../../../scene/types.ts';
import { decodeSrgb, encodeSrgb } from '../../../../spectrum/display/srgb.ts';
import type { DecodedImage } from '../../../image/decodeImage.ts';
import { clampNormalStrength } from '../../../read/limits.ts';

/** How an input reads a texture: value = texel · scale + bias per channel; `channels`: source channel of each colour component. */
export interface TexelReading {
  readonly scale: readonly number[];
  readonly bias: readonly number[];
  readonly channels: readonly [number, number, number];
  readonly colorSpace: 'srgb' | 'linear';
}

/** A texture whose texels are to be multiplied by `gain`. */
export interface AdjustedImage {
  readonly image: DecodedImage;
  readonly gain: Vec3;
}

/** The colours that an input reads; the original texture if a factor is enough. Alpha is kept. */
export function adjustedColor(image: DecodedImage, reading: TexelReading): AdjustedImage {
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

/** One channel as the texture's alpha; `gain` is at most 1, as opacities are. */
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

/** Mean of the values read from a channel. */
export function adjustedMean(image: DecodedImage, channel: number, reading: TexelReading): number {
  const table = valuesOf(channel, reading);
  let sum = 0;
  for (let i = channel; i < image.data.length; i += 4) sum += table[image.data[i]];
  return sum / (image.width * image.height);
}

/**
 * Normals that an input reads, in the encoding of `NormalTexture`: the original texture if scale and bias are the usual ones,
 * otherwise a converted one.
 */
export function adjustedNormals(
  image: DecodedImage,
  reading: TexelReading,
): { image: DecodedImage; strength: NormalTexture['strength'] } {
  const { scale, bias, colorSpace } = reading;
  const usual =
    colorSpace === 'linear' && scale[2] > 0 && [0, 1, 2].every((k) => Math.abs(2 * bias[k] + scale[k]) < 1e-5);
  if (usual)
    return { image, strength: [clampNormalStrength(scale[0] / scale[2]), clampNormalStrength(scale[1] / scale[2])] };
  const values = [0, 1, 2].map((channel) => readValues(channel, reading));
  const data = image.data.slice();
  for (let i = 0; i < data.length; i += 4) {
    const n = normalize([values[0][data[i]], values[1][data[i + 1]], values[2][data[i + 2]]], [0, 0, 1]);
    for (let k = 0; k < 3; k++) data[i + k] = Math.round(127.5 * (n[k] + 1));
  }
  return { image: { ...image, data }, strength: [1, 1] };
}

/** Byte → value, 0 or more. */
const valuesOf = (channel: number, reading: TexelReading): number[] =>
  readValues(channel, reading).map((value) => Math.max(0, value));

/** Byte → value; alpha is always linear. */
const readValues = (channel: number, { scale, bias, colorSpace }: TexelReading): number[] =>
  Array.from({ length: 256 }, (_, byte) => {
    const texel = colorSpace === 'srgb' && channel < 3 ? decodeSrgb(byte / 255) : byte / 255;
    return texel * scale[channel] + bias[channel];
  });
