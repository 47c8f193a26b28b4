import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { invert, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { AGX, sigmoid } from './agx.ts';
import { encodeSrgb } from './srgb.ts';
import { TONE_MAPPINGS, toneMap } from './toneMap.ts';

const radiance = fc.double({ min: 0, max: 1e8, noNaN: true });

describe.each(TONE_MAPPINGS)('%s', (tone) => {
  test('gives displayable values for any radiance and exposure, also outside the gamut', () => {
    const any = fc.double({ min: -1e8, max: 1e8, noNaN: true });
    fc.assert(
      fc.property(fc.tuple(any, any, any), fc.double({ min: -20, max: 20, noNaN: true }), (color, exposure) =>
        toneMap(color, exposure, tone).every((value) => value >= -1e-12 && value <= 1 + 1e-12),
      ),
    );
  });

  test('is monotonic in grey levels, and white in the limit', () => {
    // The polynomial of AgX dips by 4e-5 of the signal at its dark end.
    const slack = tone === 'agx' ? 1e-4 : 1e-12;
    fc.assert(
      fc.property(radiance, radiance, (a, b) => {
        const [low, high] = [Math.min(a, b), Math.max(a, b)];
        const shown = [low, high].map((level) => encodeSrgb(toneMap([level, level, level], 0, tone)[0]));
        expect(shown[1]).toBeGreaterThanOrEqual(shown[0]! - slack);
      }),
    );
    expect(Math.min(...toneMap([1e5, 1e5, 1e5], 0, tone))).toBeGreaterThan(0.97);
  });

  test('one EV doubles the light', () => {
    const [brighter, doubled] = [toneMap([0.2, 0.1, 0.05], 1, tone), toneMap([0.4, 0.2, 0.1], 0, tone)];
    for (const [k, value] of brighter.entries()) expect(value).toBeCloseTo(doubled[k]!, 14);
  });
});

describe('neutral', () => {
  test('is the identity up to the shoulder, and continuous there', () => {
    expect(toneMap([0.8, 0.3, 1e-4], 0, 'neutral')).toEqual([0.8, 0.3, 1e-4]);
    const above = toneMap([0.8 + 1e-9, 0.3, 1e-4], 0, 'neutral');
    [0.8, 0.3, 1e-4].forEach((value, i) => {
      expect(above[i]).toBeCloseTo(value, 8);
    });
  });

  test('very bright colours fade to white', () => {
    expect(Math.min(...toneMap([1e5, 1e3, 1e3], 0, 'neutral'))).toBeGreaterThan(0.99);
  });

  test('negative components are clamped to 0', () => {
    expect(toneMap([-1, 0.3, 0.2], 0, 'neutral')).toEqual([0, 0.3, 0.2]);
  });
});

test('linear is clipped light', () => {
  expect(toneMap([0.4, 2, -1], 1, 'linear')).toEqual([0.8, 1, 0]);
});

describe('agx', () => {
  /**
   * The curve that the polynomial was fitted to: a line of slope 2 that brings middle grey, 10 of 16.5 stops from the darkest, to half the signal, bent by powers 3 (toe) and 3.25 (shoulder) so that it
   * ends at 0 and 1. Source: T. Sobotka, AgX-S2O3 (github.com/sobotka/AgX-S2O3, AgX.py), `equation_full_curve`.
   */
  function fullCurve(x: number): number {
    const [px, py, slope] = [10 / 16.5, 0.5, 2];
    const power = x < px ? 3 : 3.25;
    const [endX, endY] = x < px ? [0, 0] : [1, 1];
    const run = Math.abs(slope * (endX - px));
    const rise = Math.abs(endY - py);
    const scale = (run ** -power * ((run / rise) ** power - 1)) ** (-1 / power);
    const way = (slope * Math.abs(x - px)) / scale;
    return py + Math.sign(x - px) * scale * (way / (1 + way ** power) ** (1 / power));
  }

  test('the polynomial agrees with its author’s curve within 0.01', () => {
    const off = Array.from({ length: 101 }, (_, i) => Math.abs(sigmoid(i / 100) - fullCurve(i / 100)));
    expect(Math.max(...off)).toBeLessThan(0.01);
  });

  test('middle grey has half the signal, and greys stay grey', () => {
    const [r, g, b] = toneMap([0.18, 0.18, 0.18], 0, 'agx');
    expect(r ** (1 / AGX.exponent)).toBeCloseTo(0.5, 2);
    expect(Math.max(Math.abs(r - g), Math.abs(r - b))).toBeLessThan(2e-3);
  });

  test('pure colours of increasing brightness tend to white', () => {
    const shares = [0, 3, 6, 10].map((ev) => toneMap([1, 0.02, 0.02], ev, 'agx')).map(([r, g]) => g / r);
    for (let i = 1; i < shares.length; i++) expect(shares[i]).toBeGreaterThan(shares[i - 1]!);
    expect(shares.at(-1)).toBeGreaterThan(0.8);
  });

  test('light outside the gamut keeps a gradation that clipping would lose', () => {
    // Monochromatic light of 500 nm has a large negative red: small changes of it are visible.
    const cyan = (red: number): Vec3 => toneMap([red, 0.4, 0.2], 0, 'agx');
    expect(cyan(-0.15)).not.toEqual(cyan(-0.1));
  });

  test('the gamut of the primaries contains sRGB', () => {
    const back = invert(AGX.inset)!;
    for (const color of [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const) {
      const inside = transform(AGX.inset, color);
      expect(Math.min(...inside)).toBeGreaterThan(0);
      transform(back, inside).forEach((value, k) => void expect(value).toBeCloseTo(color[k]!, 12));
    }
  });
});
