import type { PixelPoint } from './marks.ts';

/** Where the plot of a diagram is [px], and the first row of its legend, if that has room. */
export interface Figure {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  readonly legendAt?: PixelPoint;
}

const MARGIN = { left: 58, right: 16, top: 24, bottom: 44 } as const; // [px]
const LEGEND_WIDTH = 224; // [px]
/** From this width on the legend is at the right; in a narrow, tall picture it is below. */
const WIDE = 560;
const TALL = 1.3;
const LEAST = 40; // [px]

/** The parts of a picture of a size [px]. */
export function figureOf(width: number, height: number): Figure {
  const { left, right, top, bottom } = MARGIN;
  const wide = width >= WIDE;
  const below = !wide && height > TALL * width;
  const plotWidth = Math.max(LEAST, width - left - (wide ? LEGEND_WIDTH : right));
  const plotHeight = below ? plotWidth : Math.max(LEAST, height - top - bottom);
  const plot = { left, top, width: plotWidth, height: plotHeight };
  if (wide) return { ...plot, legendAt: [width - LEGEND_WIDTH + 18, top] };
  return below ? { ...plot, legendAt: [right, top + plotHeight + bottom] } : plot;
}
