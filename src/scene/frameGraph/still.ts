/** A picture rendered once: linear light, three values per pixel, rows from the top. */
export interface StillPixels {
  readonly width: number;
  readonly height: number;
  readonly pixels: Float32Array<ArrayBuffer>;
  /** Identifies its content, because comparing pixels would take too long. */
  readonly key: string;
}

export const makeStillPixels = (width: number, height: number, pixels: Float32Array<ArrayBuffer>): StillPixels => ({
  width,
  height,
  pixels,
  key: `${width}×${height} ${fingerprint(pixels)}`,
});

/** A 64-bit hash: two chains as in FNV-1a, over words instead of bytes. */
function fingerprint(pixels: Float32Array<ArrayBuffer>): string {
  let [a, b] = [0x811c9dc5, 0x9747b28c];
  for (const word of new Uint32Array(pixels.buffer, pixels.byteOffset, pixels.length)) {
    a = Math.imul(a ^ word, 0x01000193);
    b = Math.imul(b ^ word ^ (a >>> 15), 0x85ebca6b);
  }
  return [a, b].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('');
}

/**
 * How a still is fitted into a picture: to its height and centred, because the field of view is vertical. Wider stills are cropped; the picture is black beside
 * narrower ones. A pixel is the mean of the still's pixels under a tent filter that reaches to the next pixel of the coarser of the two, so a still of the
 * picture's size is copied unchanged.
 */
export interface StillFit {
  /** Pixels of the still per pixel of the picture. */
  readonly scale: number;
  /** Half width of the tent [px of the still]. */
  readonly reach: number;
  /** Pixel (x, y) of the picture is at scale·(x, y) + offset in the still, both relative to their first pixels' centres. */
  readonly offset: readonly [number, number];
}

export function fitStill(
  { width, height }: Pick<StillPixels, 'width' | 'height'>,
  pictureWidth: number,
  pictureHeight: number,
): StillFit {
  const scale = height / pictureHeight;
  const offset = [(width - 1 - scale * (pictureWidth - 1)) / 2, (scale - 1) / 2] as const;
  return { scale, reach: Math.max(scale, 1), offset };
}
