import type { SpectralFilter } from './spectralFilter.ts';

// Filters are linear in their five coefficients, so Lambert's and Fresnel's terms are combined as filters and evaluated at wavelengths once.

/** A filter that is the same at all wavelengths. */
export const neutralFilter = (x: number): SpectralFilter => ({ rgb: [x, x, x], uv: x, ir: x });

export const scaleFilter = ({ rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter, s: number): SpectralFilter => ({
  rgb: [s * r, s * g, s * b],
  uv: s * uv,
  ir: s * ir,
  ...(rest && { residual: { base: rest.base, share: s * rest.share } }),
});

/** p a + q b. If both have a residual, it must be of the same reflectance. */
export function mixFilters(a: SpectralFilter, p: number, b: SpectralFilter, q: number): SpectralFilter {
  const rest = a.residual ?? b.residual;
  return {
    rgb: [p * a.rgb[0] + q * b.rgb[0], p * a.rgb[1] + q * b.rgb[1], p * a.rgb[2] + q * b.rgb[2]],
    uv: p * a.uv + q * b.uv,
    ir: p * a.ir + q * b.ir,
    ...(rest && { residual: { base: rest.base, share: p * (a.residual?.share ?? 0) + q * (b.residual?.share ?? 0) } }),
  };
}

/** The product of the coefficients: of both filters in a row, as far as their bands do not overlap; a residual is scaled by the mean of the other's bands. */
export function multiplyFilters(a: SpectralFilter, b: SpectralFilter): SpectralFilter {
  const mean = ({ rgb: [red, green, blue] }: SpectralFilter): number => (red + green + blue) / 3;
  const rest = a.residual ?? b.residual;
  return {
    rgb: [a.rgb[0] * b.rgb[0], a.rgb[1] * b.rgb[1], a.rgb[2] * b.rgb[2]],
    uv: a.uv * b.uv,
    ir: a.ir * b.ir,
    ...(rest && {
      residual: {
        base: rest.base,
        share: (a.residual?.share ?? 0) * mean(b) + (b.residual?.share ?? 0) * mean(a),
      },
    }),
  };
}

/** An upper bound of the filter over all wavelengths. */
export const maxOfFilter = ({ rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter): number =>
  Math.max(r, g, b, uv, ir) + Math.abs(rest?.share ?? 0);
