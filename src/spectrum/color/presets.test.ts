import { describe, expect, test } from 'vitest';
import { judged } from '../../../tests/support/spectra.ts';
import { dot, type Vec3 } from '../../math/vec3.ts';
import { tristimulus } from '../observer/standardObserver.ts';
import { MATERIAL_PRESETS } from '../reflectance/materialPresets.ts';
import { WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { LIGHT_PRESETS } from '../sources/lightPresets.ts';
import { DAYLIGHT, type LineSpectrum, type SampledSpectrum, spectralRadiance } from '../sources/lightSpectrum.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor } from './observerColor.ts';

const light = (name: string) => LIGHT_PRESETS.get(name)!.spectrum;
const nanometres = (name: string) => (light(name) as LineSpectrum).lines.map((line) => line.wavelength * 1e9);

describe('light presets', () => {
  test.each([...LIGHT_PRESETS.keys()])('%s has the luminance 1 and a colour', (name) => {
    const white = colorOfSpectrum(light(name));
    expect(dot(LUMINANCE_WEIGHTS, white)).toBeCloseTo(1, 6);
    expect(white.every(Number.isFinite)).toBe(true);
  });

  test.each([
    ['fluorescent', 'FL2'],
    ['triphosphor', 'FL11'],
    ['led', 'LED-B3'],
    ['street-sodium', 'HP1'],
  ])('%s has colour-science’s chromaticity of %s', (name, cie) => {
    const spectrum = light(name) as SampledSpectrum;
    const [X, Y, Z] = tristimulus((wavelength) => spectralRadiance(spectrum, wavelength));
    [X, Y].forEach((value, i) => void expect(value / (X + Y + Z)).toBeCloseTo(judged.lamps[cie].xy[i], 6));
    expect(spectrum.values).toEqual(judged.lamps[cie].values);
  });

  test('hydrogen’s lines agree with Rydberg’s formula', () => {
    const series: readonly (readonly [lower: number, upper: number])[] = [
      [1, 2],
      [2, 6],
      [2, 5],
      [2, 4],
      [2, 3],
      [3, 6],
      [3, 5],
      [3, 4],
      [4, 5],
    ];
    const RYDBERG = 1.0967758e7;
    nanometres('hydrogen').forEach((value, i) => {
      const [n, m] = series[i];
      const inVacuum = 1e9 / (RYDBERG * (1 / n ** 2 - 1 / m ** 2));
      const expected = inVacuum < 200 ? inVacuum : inVacuum / 1.000277;
      expect(Math.abs(value / expected - 1)).toBeLessThan(3e-5);
    });
  });

  test('Lyman α becomes visible at D = 1/5, and Paschen α at D = 3', () => {
    const brightness = (D: number) =>
      dot(LUMINANCE_WEIGHTS, observedColor(WHITE_FILTER, WHITE_FILTER, light('hydrogen'), 1, D));
    expect(brightness(121.567 / 555)).toBeGreaterThan(5 * brightness(1));
    expect(brightness(1875.1 / 555)).toBeGreaterThan(0.1 * brightness(1));
    expect(brightness(0.1)).toBe(0);
  });

  test('sodium is orange and mercury has blue, green and yellow', () => {
    const [r, g, b] = colorOfSpectrum(light('sodium'));
    expect([r > g, g > 0, b < 0]).toEqual([true, true, true]);
    expect(nanometres('mercury').filter((value) => value > 400 && value < 600)).toHaveLength(5);
  });
});

describe('material presets', () => {
  const seen = (name: string, D: number): Vec3 =>
    observedColor(MATERIAL_PRESETS.get(name)!.filter, WHITE_FILTER, DAYLIGHT, 1 / D, D);

  test.each([...MATERIAL_PRESETS])('%s reflects at most all light', (_, { filter, about }) => {
    for (const value of [...filter.rgb, filter.uv, filter.ir]) {
      expect(value).toBeGreaterThan(0);
      expect(value).toBeLessThanOrEqual(1);
    }
    expect(about).not.toBe('');
  });

  test('a leaf is brighter, and no longer green, beyond its red edge', () => {
    const [rest, infrared] = [seen('leaf', 1), seen('leaf', 2)];
    expect(rest[1]).toBeGreaterThan(rest[0]);
    expect(dot(LUMINANCE_WEIGHTS, infrared)).toBeGreaterThan(3 * dot(LUMINANCE_WEIGHTS, rest));
  });

  test('gold loses its colour: a mirror in the infrared, dull in the ultraviolet', () => {
    seen('gold', 2.3).forEach((value) => void expect(value).toBeCloseTo(0.98, 2));
    seen('gold', 0.44).forEach((value) => void expect(value).toBeCloseTo(0.37, 2));
  });
});
