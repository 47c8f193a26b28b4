type Color = readonly [r: number, g: number, b: number];

/** Colours of a ghost's contours, and of what is in the world's past and in its future: linear sRGB, told apart by all kinds of colour vision. */
export const OVERLAY_COLORS = {
  contour: [1, 0.05, 0.5],
  past: [0.03, 0.3, 1],
  future: [1, 0.42, 0.01],
} as const satisfies Readonly<Record<string, Color>>;
