import { describe, expect, test } from 'vitest';
import { deltaE2000, labOf } from '../../../tests/support/deltaE.ts';
import { thermal } from '../../../tests/support/spectra.ts';
import { IDENTITY, invert, transform } from '../../math/mat3.ts';
import { random as seeded } from '../../math/random.ts';
import { addScaled, dot, scale, type Vec3 } from '../../math/vec3.ts';
import { LUMINANCE_WEIGHTS, observedColor, XYZ_TO_RENDER_SRGB } from '../color/observerColor.ts';
import { filterFromRgb, WHITE_FILTER } from '../reflectance/spectralFilter.ts';
import { columnOf, tableColor } from './dopplerTable.ts';
import { bandOverlaps, filteredBlackbodyTable, pairedBands } from './filterPairs.ts';

const TO_XYZ = invert(XYZ_TO_RENDER_SRGB) ?? IDENTITY;
const lab = (rgb: Vec3) => labOf(transform(TO_XYZ, rgb), transform(TO_XYZ, [1, 1, 1]));
const between = (random: () => number, from: number, to: number) => from * (to / from) ** random();
const anyColor = (random: () => number): Vec3 => [random(), random(), random()];

/** Mean and 95th percentile of the errors of `found` against `expected`: luminance, relative to white's in the same light, and ΔE₀₀. */
function errors(pairs: readonly (readonly [found: Vec3, expected: Vec3, white: Vec3])[]) {
  const percentiles = (values: readonly number[]) => {
    const rising = [...values].sort((a, b) => a - b);
    return { mean: values.reduce((a, b) => a + b) / values.length, p95: rising[Math.floor(0.95 * values.length)] };
  };
  const luminance = (rgb: Vec3) => dot(LUMINANCE_WEIGHTS, rgb);
  return {
    luminance: percentiles(
      pairs.map(([found, expected, white]) => Math.abs(luminance(found) - luminance(expected)) / luminance(white)),
    ),
    color: percentiles(
      pairs.map(([found, expected, white]) => {
        const exposed = 1 / luminance(white);
        return deltaE2000(lab(scale(found, exposed)), lab(scale(expected, exposed)));
      }),
    ),
  };
}

describe('coloured light on coloured surfaces', () => {
  test('at rest agrees with integration: bands and their overlaps', () => {
    const random = seeded(1);
    const pairs = Array.from({ length: 200 }, () => {
      const [a, k] = [anyColor(random), anyColor(random)];
      const D = between(random, 0.5, 2);
      const shares = [0, 1, 2].map((i) => (a[i] - a[(i + 1) % 3]) * (k[i] - k[(i + 1) % 3]));
      const bands = observedColor(
        filterFromRgb([a[0] * k[0], a[1] * k[1], a[2] * k[2]]),
        WHITE_FILTER,
        thermal(6504 * D),
        1 / D,
        D,
      );
      const found = bandOverlaps(6504 * D, pairedBands(D, 3)).reduce(
        (sum, color, i) => addScaled(sum, color, -shares[i]),
        bands,
      );
      const at = (surface: Vec3, light: Vec3) =>
        observedColor(filterFromRgb(surface), filterFromRgb(light), thermal(6504), 1, D);
      // Without the light's own luminance under the shift.
      const white = observedColor(WHITE_FILTER, WHITE_FILTER, thermal(6504 * D), 1, 1);
      const level = dot(LUMINANCE_WEIGHTS, at([1, 1, 1], [1, 1, 1])) / dot(LUMINANCE_WEIGHTS, white);
      return [found, scale(at(a, k), 1 / level), white] as const;
    });
    const { luminance, color } = errors(pairs);
    expect(luminance.p95).toBeLessThan(1e-3);
    expect(color.p95).toBeLessThan(0.1);
  });

  test.each([
    ['0.8 to 1.2', 6504, [0.8, 1.2]],
    ['1/2 to 2', 6504, [0.5, 2]],
    ['0.8 to 1.2, at 3000 K', 3000, [0.8, 1.2]],
  ] as const)('in motion agrees with integration: shifts from %s', (_, T, [from, to]) => {
    const random = seeded(2);
    const pairs = Array.from({ length: 6 }, () => anyColor(random)).flatMap((k) => {
      const table = filteredBlackbodyTable({ temperature: T, filter: k }, 3);
      return Array.from({ length: 40 }, () => {
        const a = anyColor(random);
        const [Din, Dout] = [between(random, from, to), between(random, from, to)];
        const D = Math.min(Math.max(Din * Dout, 0.45), 2.2);
        const found = tableColor(table, columnOf(table, D), columnOf(table, Dout), filterFromRgb(a));
        const bare = observedColor(WHITE_FILTER, WHITE_FILTER, thermal(T), D, 1);
        const level = dot(LUMINANCE_WEIGHTS, bare);
        const expected = scale(
          observedColor(filterFromRgb(a), filterFromRgb(k), thermal(T), D / Dout, Dout),
          1 / level,
        );
        return [found, expected, scale(bare, 1 / level)] as const;
      });
    });
    const { luminance, color } = errors(pairs);
    // Multiplied channel by channel the errors were 0.007 and 0.02, ΔE₀₀ 2.8 and 9.
    expect(luminance.mean).toBeLessThan(5e-4);
    expect(luminance.p95).toBeLessThan(2e-3);
    expect(color.mean).toBeLessThan(0.2);
    expect(color.p95).toBeLessThan(0.6);
  });

  test('with ultraviolet and infrared coefficients agrees with integration', () => {
    const random = seeded(3);
    const k: Vec3 = [1, 0.5, 0.1];
    const table = filteredBlackbodyTable({ temperature: 6504, filter: k }, 4);
    const pairs = Array.from({ length: 60 }, () => {
      const a = filterFromRgb(anyColor(random), random(), random());
      const [Din, Dout] = [between(random, 0.8, 1.2), between(random, 0.6, 1.6)];
      const found = tableColor(table, columnOf(table, Din * Dout), columnOf(table, Dout), a);
      const bare = observedColor(WHITE_FILTER, WHITE_FILTER, thermal(6504), Din, Dout);
      const level = 1 / dot(LUMINANCE_WEIGHTS, bare);
      return [
        found,
        scale(observedColor(a, filterFromRgb(k), thermal(6504), Din, Dout), level),
        scale(bare, level),
      ] as const;
    });
    const { luminance, color } = errors(pairs);
    expect(luminance.p95).toBeLessThan(2e-3);
    expect(color.p95).toBeLessThan(1);
  });
});
