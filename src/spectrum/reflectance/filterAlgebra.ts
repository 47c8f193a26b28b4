import type { FilterResidual, SpectralFilter } from './spectralFilter.ts';

// Filters are linear in their five coefficients, so Lambert's and Fresnel's terms are combined as filters and evaluated at wavelengths once.

/** A filter that is the same at all wavelengths. */
export const neutralFilter = (x: number): SpectralFilter => ({ rgb: [x, x, x], uv: x, ir: x });

export const scaleFilter = ({ rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter, s: number): SpectralFilter => ({
  rgb: [s * r, s * g, s * b],
  uv: s * uv,
  ir: s * ir,
  ...(rest && { residual: { at: rest.at, share: s * rest.share } }),
});

/** p a + q b */
export function mixFilters(a: SpectralFilter, p: number, b: SpectralFilter, q: number): SpectralFilter {
  const rest = sumOfResiduals(a.residual, p, b.residual, q);
  return {
    rgb: [p * a.rgb[0] + q * b.rgb[0], p * a.rgb[1] + q * b.rgb[1], p * a.rgb[2] + q * b.rgb[2]],
    uv: p * a.uv + q * b.uv,
    ir: p * a.ir + q * b.ir,
    ...(rest && { residual: rest }),
  };
}

function sumOfResiduals(
  a: FilterResidual | undefined,
  p: number,
  b: FilterResidual | undefined,
  q: number,
): FilterResidual | undefined {
  if (!a || !b) {
    const rest = a ?? b;
    return rest && { at: rest.at, share: (a ? p : q) * rest.share };
  }
  if (a.at === b.at) return { at: a.at, share: p * a.share + q * b.share };
  const [first, second] = [p * a.share, q * b.share];
  // Its share bounds it, as that of others does.
  const share = Math.max(Math.abs(first) + Math.abs(second), Number.MIN_VALUE);
  const at = (wavelength: number, width?: number): number =>
    (first * a.at(wavelength, width) + second * b.at(wavelength, width)) / share;
  return { at, share };
}

/** The product of the coefficients: of both filters in a row, as far as their bands do not overlap; a residual is scaled by the mean of the other's bands. */
export function multiplyFilters(a: SpectralFilter, b: SpectralFilter): SpectralFilter {
  const mean = ({ rgb: [red, green, blue] }: SpectralFilter): number => (red + green + blue) / 3;
  const rest = sumOfResiduals(a.residual, mean(b), b.residual, mean(a));
  return {
    rgb: [a.rgb[0] * b.rgb[0], a.rgb[1] * b.rgb[1], a.rgb[2] * b.rgb[2]],
    uv: a.uv * b.uv,
    ir: a.ir * b.ir,
    ...(rest && { residual: rest }),
  };
}

/** An upper bound of the filter over all wavelengths. */
export const maxOfFilter = ({ rgb: [r, g, b], uv, ir, residual: rest }: SpectralFilter): number =>
  Math.max(r, g, b, uv, ir) + Math.abs(rest?.share ?? 0);
