import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { addScaled, dot, type Vec3 } from '../../math/vec3.ts';
import { DAY_SKY } from '../../scene/lights/sceneLights.ts';
import { colorMatching, NANOMETRE, WAVELENGTHS } from '../observer/standardObserver.ts';
import { filterFromRgb, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../sources/lightSpectrum.ts';
import { LUMINANCE_WEIGHTS, observedColor, toLinearSrgb } from './observerColor.ts';
import { REDDENED, SCATTERED, SCATTERED_COLOR, type SkyParts, scatteredShare, skyParts } from './scatteredLight.ts';

describe('scattered light', () => {
  // Planck's law times λ⁻⁴, summed independently.
  test('has the colour of λ⁻⁴ times a blackbody, at any shift', () => {
    const radiance = (l: number) => (l * 1e6) ** -9 / Math.expm1(1.438776877e-2 / (l * 6504));
    const seen = (D: number): Vec3 => {
      const xyz = [0, 0, 0];
      for (const l of WAVELENGTHS)
        colorMatching(l).forEach((cmf, k) => {
          xyz[k] += cmf * D * radiance(D * l) * NANOMETRE;
        });
      return toLinearSrgb(xyz as unknown as Vec3);
    };
    const luminance = dot(LUMINANCE_WEIGHTS, seen(1));
    for (const D of [0.3, 0.7, 1, 1.6, 4])
      observedColor(WHITE_FILTER, WHITE_FILTER, SCATTERED, 1, D).forEach((value, k) => {
        const expected = seen(D)[k] / luminance;
        expect(Math.abs(value - expected)).toBeLessThan((2e-3 * Math.max(...seen(D).map(Math.abs))) / luminance);
      });
  });

  test('stays blue: behind the observer as well, and ahead it is bluer than its haze', () => {
    for (const D of [0.7, 1, 1.5]) {
      const [r, g, b] = observedColor(WHITE_FILTER, WHITE_FILTER, SCATTERED, 1, D);
      expect(b).toBeGreaterThan(g);
      expect(g).toBeGreaterThan(r);
    }
  });

  test('makes up most of the zenith of a clear day, and little of its horizon', () => {
    for (const [color, least, most] of [
      [DAY_SKY.color, 0.9, 1],
      [DAY_SKY.gradient.horizon, 0.1, 0.3],
      [DAY_SKY.gradient.ground, 0, 0],
    ] as const) {
      const share = scatteredShare(color);
      const rest = addScaled(color, SCATTERED_COLOR, -share);
      expect(share / dot(LUMINANCE_WEIGHTS, color)).toBeGreaterThanOrEqual(least);
      expect(share / dot(LUMINANCE_WEIGHTS, color)).toBeLessThanOrEqual(most);
      // The rest is grey.
      expect(Math.max(...rest) - Math.min(...rest)).toBeLessThan(
        0.08 * Math.max(...color) + 1e-9 + (share === 0 ? 1 : 0),
      );
    }
  });
});

describe('light at dusk', () => {
  const DUSK: readonly Vec3[] = [
    [0.8, 0.35, 0.1],
    [1, 0.62, 0.35],
    [0.9, 0.2, 0.05],
    [0.7, 0.45, 0.55],
    [0.4, 0.33, 0.6],
  ];
  const lightsOf = ({ scattered, reddened }: SkyParts) =>
    [scattered, ...reddened].map((share, i) => [share, [SCATTERED, ...REDDENED][i]] as const);
  const seenAt = (color: Vec3, D: number): Vec3 => {
    const parts = skyParts(color);
    const own = (sum: Vec3, [share, spectrum]: readonly [number, LightSpectrum]) =>
      addScaled(sum, observedColor(WHITE_FILTER, WHITE_FILTER, spectrum, 1, D), share);
    return lightsOf(parts).reduce(own, observedColor(WHITE_FILTER, filterFromRgb(parts.rest), DAYLIGHT, 1, D));
  };

  test('has the sky’s colour at rest, whatever that is', () => {
    const share = fc.double({ min: 0, max: 2, noNaN: true });
    fc.assert(
      fc.property(fc.tuple(share, share, share), (color) => {
        const parts = skyParts(color);
        seenAt(color, 1).forEach((value, k) => {
          expect(value).toBeCloseTo(color[k], 6);
        });
        for (const [luminance] of lightsOf(parts)) expect(luminance).toBeGreaterThanOrEqual(0);
        expect(Math.min(...parts.rest)).toBeGreaterThanOrEqual(-1e-12);
      }),
    );
  });

  test('leaves only a grey filter for evening skies', () => {
    for (const color of DUSK) {
      const { rest } = skyParts(color);
      expect(Math.max(...rest) - Math.min(...rest)).toBeLessThan(0.04 * Math.max(...color));
    }
  });

  test('never turns green at high speed, unlike filter bands', () => {
    const greenness = ([r, g, b]: Vec3) => (g - Math.max(r, b)) / Math.max(r, g, b);
    const shifts = Array.from({ length: 61 }, (_, i) => 0.5 * 4 ** (i / 60));
    const most = (seen: (D: number) => Vec3) => Math.max(...shifts.map((D) => greenness(seen(D))));
    for (const color of DUSK) expect(most((D) => seenAt(color, D))).toBeLessThan(0.08);
    for (const color of DUSK)
      expect(most((D) => observedColor(WHITE_FILTER, filterFromRgb(color), DAYLIGHT, 1, D))).toBeGreaterThan(0.2);
  });
});
