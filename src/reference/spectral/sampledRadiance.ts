/**
 * Radiance or irradiance, sampled for a receiver: values at the wavelengths of its `SpectralContext`, or linear sRGB; and spectral lines, light of
 * single wavelengths, which do not depend on the sampled ones. No light has neither values nor lines.
 */
export interface SampledRadiance {
  readonly values: readonly number[];
  readonly lines: readonly RadianceLine[];
}

/** Light of a single wavelength [m, receiver's frame]; `value` is its integral over the wavelength. */
export interface RadianceLine {
  readonly wavelength: number;
  readonly value: number;
}

export const NO_LIGHT: SampledRadiance = { values: [], lines: [] };

export const isDark = ({ values, lines }: SampledRadiance): boolean => values.length + lines.length === 0;

/** a + s b */
export function plus(a: SampledRadiance, b: SampledRadiance, s = 1): SampledRadiance {
  if (s === 0 || isDark(b)) return a;
  if (isDark(a)) return times(b, s);
  return { values: sumOf(a.values, b.values, s), lines: a.lines.concat(timesLines(b.lines, s)) };
}

export function times(light: SampledRadiance, s: number): SampledRadiance {
  if (s === 1 || isDark(light)) return light;
  return s === 0 ? NO_LIGHT : { values: timesValues(light.values, s), lines: timesLines(light.lines, s) };
}

export const eachLine = (
  lines: readonly RadianceLine[],
  change: (line: RadianceLine) => RadianceLine,
): readonly RadianceLine[] => (lines.length === 0 ? lines : lines.map(change));

const timesLines = (lines: readonly RadianceLine[], s: number): readonly RadianceLine[] =>
  eachLine(lines, ({ wavelength, value }) => ({ wavelength, value: s * value }));

// slice() keeps numbers unboxed and is faster than growing arrays.

export function timesValues(values: readonly number[], s: number): readonly number[] {
  const result = values.slice();
  for (let i = 0; i < result.length; i++) result[i] *= s;
  return result;
}

/** a + s b; light of lines only has no values. */
function sumOf(a: readonly number[], b: readonly number[], s: number): readonly number[] {
  if (a.length === 0) return timesValues(b, s);
  const result = a.slice();
  for (let i = 0; i < b.length; i++) result[i] += s * b[i];
  return result;
}
