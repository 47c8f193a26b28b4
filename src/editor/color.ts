import { encodeSrgb } from '../spectrum/display/srgb.ts';

/** Linear sRGB → `#rrggbb`, clamped to 0 … 1. */
export const cssColor = (linear: readonly number[]): string =>
  `#${linear
    .map((x) =>
      Math.round(255 * encodeSrgb(x))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;
