import { describe, expect, test } from 'vitest';
import { addScaled, dot, type Vec3 } from '../math/vec3.ts';
import { DAY } from '../scene/daylight.ts';
import { WHITE } from './bands.ts';
import { colorMatching, NANOMETRE, WAVELENGTHS } from './cie1931.ts';
import { LUMINANCE, seenColor, toLinearSrgb } from './observerColor.ts';
import { SCATTERED, SCATTERED_COLOR, scatteredShare } from './scatteredLight.ts';

describe('scattered light', () => {
  // Planck's law times λ⁻⁴, summed here by itself.
  test('has the colour of λ⁻⁴ times a blackbody, seen at any shift', () => {
    const radiance = (l: number) => (l * 1e6) ** -9 / Math.expm1(1.438776877e-2 / (l * 6504));
    const seen = (D: number): Vec3 => {
      const xyz = [0, 0, 0];
      for (const l of WAVELENGTHS)
        colorMatching(l).forEach((cmf, k) => {
          xyz[k] += cmf * D * radiance(D * l) * NANOMETRE;
        });
      return toLinearSrgb(xyz as unknown as Vec3);
    };
    const luminance = dot(LUMINANCE, seen(1));
    for (const D of [0.3, 0.7, 1, 1.6, 4])
      seenColor(WHITE, WHITE, SCATTERED, 1, D).forEach((value, k) => {
        const expected = seen(D)[k] / luminance;
        expect(Math.abs(value - expected)).toBeLessThan((2e-3 * Math.max(...seen(D).map(Math.abs))) / luminance);
      });
  });

  test('stays blue: a sky that is fled from is as blue, and one ahead is bluer than its haze', () => {
    for (const D of [0.7, 1, 1.5]) {
      const [r, g, b] = seenColor(WHITE, WHITE, SCATTERED, 1, D);
      expect(b).toBeGreaterThan(g);
      expect(g).toBeGreaterThan(r);
    }
  });

  test('is nearly all of the zenith of a clear day, and little of its horizon', () => {
    for (const [color, least, most] of [
      [DAY.zenith, 0.9, 1],
      [DAY.horizon, 0.1, 0.3],
      [DAY.ground, 0, 0],
    ] as const) {
      const share = scatteredShare(color);
      const rest = addScaled(color, SCATTERED_COLOR, -share);
      expect(share / dot(LUMINANCE, color)).toBeGreaterThanOrEqual(least);
      expect(share / dot(LUMINANCE, color)).toBeLessThanOrEqual(most);
      // What is left is grey.
      expect(Math.max(...rest) - Math.min(...rest)).toBeLessThan(
        0.08 * Math.max(...color) + 1e-9 + (share === 0 ? 1 : 0),
      );
    }
  });
});
