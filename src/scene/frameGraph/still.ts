/** A picture that was made once: linear light, three values per pixel, rows from the top. */
export interface StillPixels {
  readonly width: number;
  readonly height: number;
  readonly pixels: Float32Array<ArrayBuffer>;
  /** Tells it apart from others by its content, where comparing pixels would take too long. */
  readonly key: string;
}

export const makeStillPixels = (width: number, height: number, pixels: Float32Array<ArrayBuffer>): StillPixels => ({
  width,
  height,
  pixels,
  key: `${width}×${height} ${fingerprint(pixels)}`,
});

/** 64 bits, by two of FNV-1a's chains over words instead of bytes. */
function fingerprint(pixels: Float32Array<ArrayBuffer>): string {
  let [a, b] = [0x811c9dc5, 0x9747b28c];
  for (const word of new Uint32Array(pixels.buffer, pixels.byteOffset, pixels.length)) {
    a = Math.imul(a ^ word, 0x01000193);
    b = Math.imul(b ^ word ^ (a >>> 15), 0x85ebca6b);
  }
  return [a, b].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('');
}

/**
 * Where a still lies in a picture: as high as that and in its middle, for a field of view is an angle up and down. What of it is wider is cut off,
 * and beside it nothing is seen. A pixel of the picture is the mean of the still's under a tent that reaches as far as the next pixel
 * of the coarser of the two: where both have the same size, it is the still's own.
 */
export interface StillFit {
  /** How many of the still's pixels are one of the picture's. */
  readonly scale: number;
  /** How far the tent reaches [px of the still]. */
  readonly reach: number;
  /** The still's place of the picture's pixel (x, y) is scale·(x, y) + offset, both by their first pixels' centres. */
  readonly offset: readonly [number, number];
}

export function fitStill(
  { width, height }: Pick<StillPixels, 'width' | 'height'>,
  wide: number,
  high: number,
): StillFit {
  const scale = height / high;
  const offset = [(width - 1 - scale * (wide - 1)) / 2, (scale - 1) / 2] as const;
  return { scale, reach: Math.max(scale, 1), offset };
}
