import type { PictureSize } from '../scene/view/pictureViews.ts';

/** Part of the page's catalogue; the command line uses the English text. */
export const maxSizeTexts = {
  'picture.tooLarge': [
    '{{width}} × {{height}} pixels are too many for the graphics device here, which draws up to {{largest}} along each side; make the picture smaller.',
    '{{width}} × {{height}} 像素超出了此处图形设备的能力（每边最多 {{largest}}）；请缩小图片。',
  ],
} as const;

/** A picture larger than the graphics device supports, which it would leave blank. */
export class PictureTooLargeError extends Error {
  readonly fill: PictureSize & { readonly largest: number };
  constructor(size: PictureSize, largest: number) {
    const fill = { ...size, largest };
    super(
      maxSizeTexts['picture.tooLarge'][0].replace(/\{\{(\w+)\}\}/g, (_, name: keyof typeof fill) => `${fill[name]}`),
    );
    this.fill = fill;
  }
}

/** `largest`: maximum pixels per side. */
export function assertPictureSize({ width, height }: PictureSize, largest: number): void {
  if (Math.max(width, height) > largest) throw new PictureTooLargeError({ width, height }, largest);
}
