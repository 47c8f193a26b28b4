import type { DecodedImage } from './decodeImage.ts';

/** The image (white if none) with alpha from a channel of another, nearest pixel. */
export function withAlphaFrom(image: DecodedImage | undefined, alpha: DecodedImage, channel: number): DecodedImage {
  const { width, height } = image ?? alpha;
  const data = image ? image.data.slice() : new Uint8Array(width * height * 4).fill(255);
  for (let y = 0; y < height; y++) {
    const row = Math.floor((y * alpha.height) / height) * alpha.width;
    for (let x = 0; x < width; x++) {
      const from = row + Math.floor((x * alpha.width) / width);
      data[4 * (y * width + x) + 3] = alpha.data[4 * from + channel];
    }
  }
  return { width, height, data };
}

/** Mean of a linear channel, 0 … 1. */
export function channelMean({ data }: DecodedImage, channel: number): number {
  let sum = 0;
  for (let i = channel; i < data.length; i += 4) sum += data[i];
  return (4 * sum) / (255 * data.length);
}
