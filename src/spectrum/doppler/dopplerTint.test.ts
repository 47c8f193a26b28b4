import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { dopplerTint } from './dopplerTint.ts';

const unitInterval = fc.double({ min: 0, max: 1, noNaN: true });
const rgb = fc.tuple(unitInterval, unitInterval, unitInterval);

describe('dopplerTint', () => {
  test('D = 1, or a mix of 0, returns the colour', () => {
    fc.assert(
      fc.property(rgb, fc.double({ min: 0.02, max: 100, noNaN: true }), (color, D) => {
        for (const tinted of [dopplerTint(color, 1, 1), dopplerTint(color, D, 0)])
          tinted.forEach((value, i) => {
            expect(value).toBeCloseTo(color[i], 12);
          });
      }),
    );
  });

  test('white turns blue ahead and red behind', () => {
    const [r1, , b1] = dopplerTint([1, 1, 1], 1.5, 1);
    expect(b1 / r1).toBeGreaterThan(1.3);
    const [r2, , b2] = dopplerTint([1, 1, 1], 0.7, 1);
    expect(r2 / b2).toBeGreaterThan(1.3);
  });

  // Planck's law directly: a primary of white becomes B(λ, D·T)/B(λ, T), without the D⁴ of beaming.
  test('white has the colour of a blackbody at D times the temperature', () => {
    const planck = (T: number) => 1 / Math.expm1(1.438777e-2 / (549e-9 * T));
    for (const D of [0.3, 0.8, 1.2, 4])
      expect(dopplerTint([1, 1, 1], D, 1)[1] * D ** 4).toBeCloseTo(planck(D * 6504) / planck(6504), 9);
  });

  test('pure red shifts into green, then out of the red primary', () => {
    const [r, g] = dopplerTint([1, 0, 0], 611 / 549, 1);
    expect(g).toBeGreaterThan(0.8);
    expect(r).toBeGreaterThan(0.5);
    expect(dopplerTint([1, 0, 0], 0.8, 1)[0]).toBeLessThan(0.02);
  });

  test('all light fades far into the infrared and the ultraviolet, and is always finite', () => {
    expect(Math.max(...dopplerTint([1, 1, 1], 0.1, 1))).toBeLessThan(1e-6);
    expect(Math.max(...dopplerTint([1, 1, 1], 50, 1))).toBeLessThan(1e-3);
    fc.assert(
      fc.property(rgb, fc.double({ min: 1e-9, max: 1e9, noNaN: true }), unitInterval, (color, D, mix) =>
        dopplerTint(color, D, mix).every((value) => Number.isFinite(value) && value >= 0),
      ),
    );
  });
});
