import type { Size } from './painter.ts';

/** Part of the page's catalogue of messages; the command line says it in English. */
export const largestWords = {
  'picture.tooLarge': [
    '{{width}} × {{height}} pixels are too many for the graphics device here, which draws up to {{largest}} along each side; make the picture smaller.',
    '{{width}} × {{height}} 像素超出了此处图形设备的能力（每边最多 {{largest}}）；请缩小图片。',
  ],
} as const;

/** A picture that the graphics device would leave blank. */
export class PictureTooLarge extends Error {
  readonly fill: Size & { readonly largest: number };
  constructor(size: Size, largest: number) {
    const fill = { ...size, largest };
    super(
      largestWords['picture.tooLarge'][0].replace(/\{\{(\w+)\}\}/g, (_, name: keyof typeof fill) => `${fill[name]}`),
    );
    this.fill = fill;
  }
}

/** `largest`: the most pixels of a side. */
export function refuseLarger({ width, height }: Size, largest: number): void {
  if (Math.max(width, height) > largest) throw new PictureTooLarge({ width, height }, largest);
}
