import type { Bands } from '../spectrum/bands.ts';

// What filters light is linear in its five coefficients; so Lambert's and Fresnel's shares are mixed of them, and asked at wavelengths once.

/** The same at all wavelengths. */
export const neutral = (x: number): Bands => ({ rgb: [x, x, x], uv: x, ir: x });

export const dimmed = ({ rgb: [r, g, b], uv, ir, rest }: Bands, s: number): Bands => ({
  rgb: [s * r, s * g, s * b],
  uv: s * uv,
  ir: s * ir,
  ...(rest && { rest: { of: rest.of, share: s * rest.share } }),
});

/** p a + q b, of which one has a rest, or both have that of one reflectance. */
export function mixed(a: Bands, p: number, b: Bands, q: number): Bands {
  const rest = a.rest ?? b.rest;
  return {
    rgb: [p * a.rgb[0] + q * b.rgb[0], p * a.rgb[1] + q * b.rgb[1], p * a.rgb[2] + q * b.rgb[2]],
    uv: p * a.uv + q * b.uv,
    ir: p * a.ir + q * b.ir,
    ...(rest && { rest: { of: rest.of, share: p * (a.rest?.share ?? 0) + q * (b.rest?.share ?? 0) } }),
  };
}

/** Nowhere is more left than this. */
export const largest = ({ rgb: [r, g, b], uv, ir, rest }: Bands): number =>
  Math.max(r, g, b, uv, ir) + Math.abs(rest?.share ?? 0);
