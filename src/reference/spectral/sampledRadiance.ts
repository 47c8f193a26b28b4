import { scale, type Vec3 } from '../../math/vec3.ts';

/**
 * Radiance or irradiance, sampled for a receiver: values at the wavelengths of its `SpectralContext`, or linear sRGB; and spectral lines, light of
 * single wavelengths, which do not depend on the sampled ones. No light has none of these.
 */
export interface SampledRadiance {
  readonly values: readonly number[];
  readonly lines: readonly RadianceLine[];
  /** Linear sRGB of each light, in colour modes that shift every light by itself (rgbSensor.ts); there it is all. */
  readonly colors?: readonly Vec3[];
}

/** Light of a single wavelength [m, receiver's frame]; `value` is its integral over the wavelength. */
export interface RadianceLine {
  readonly wavelength: number;
  readonly value: number;
}

export const NO_LIGHT: SampledRadiance = { values: [], lines: [] };

export const isDark = ({ values, lines, colors }: SampledRadiance): boolean =>
  values.length + lines.length === 0 && !colors;

/** a + s b */
export function plus(a: SampledRadiance, b: SampledRadiance, s = 1): SampledRadiance {
  if (s === 0 || isDark(b)) return a;
  if (isDark(a)) return times(b, s);
  if (a.colors) return { ...NO_LIGHT, colors: a.colors.concat(times(b, s).colors ?? []) };
  return { values: sumOf(a.values, b.values, s), lines: a.lines.concat(timesLines(b.lines, s)) };
}

export function times(light: SampledRadiance, s: number): SampledRadiance {
  if (s === 1 || isDark(light)) return light;
  if (light.colors) return eachColor(light, (color) => scale(color, s));
  return s === 0 ? NO_LIGHT : { values: timesValues(light.values, s), lines: timesLines(light.lines, s) };
}

export const eachLine = (
  lines: readonly RadianceLine[],
  change: (line: RadianceLine) => RadianceLine,
): readonly RadianceLine[] => (lines.length === 0 ? lines : lines.map(change));

export const eachColor = ({ colors = [] }: SampledRadiance, change: (color: Vec3) => Vec3): SampledRadiance => ({
  ...NO_LIGHT,
  colors: colors.map(change),
});

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

/** One of `of` sampled values alone, as often as it stands for all; lines keep their share, as often as `of` such lights are added up. */
export const onlyValue = ({ values, lines }: SampledRadiance, index: number, of: number): SampledRadiance => ({
  values: values.map((value, i) => (i === index ? of * value : 0)),
  lines,
});
