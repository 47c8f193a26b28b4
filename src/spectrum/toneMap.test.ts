import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { toneMap } from './toneMap.ts';

const radiance = fc.double({ min: 0, max: 1e8, noNaN: true });
const rgb = fc.tuple(radiance, radiance, radiance);

describe('toneMap', () => {
  test('gives what can be displayed, for any radiance and exposure', () => {
    fc.assert(
      fc.property(rgb, fc.double({ min: -20, max: 20, noNaN: true }), (color, exposure) =>
        toneMap(color, exposure).every((value) => value >= -1e-12 && value <= 1 + 1e-12),
      ),
    );
  });

  test('keeps the order of grey levels', () => {
    fc.assert(
      fc.property(radiance, radiance, (a, b) => {
        const [low, high] = [Math.min(a, b), Math.max(a, b)];
        expect(toneMap([high, high, high], 0)[0]).toBeGreaterThanOrEqual(toneMap([low, low, low], 0)[0] - 1e-12);
      }),
    );
  });

  test('one EV doubles', () => {
    expect(toneMap([0.2, 0.1, 0.05], 1)).toEqual(toneMap([0.4, 0.2, 0.1], 0));
  });

  test('changes nothing up to the shoulder, and has no step there', () => {
    expect(toneMap([0.8, 0.3, 1e-4], 0)).toEqual([0.8, 0.3, 1e-4]);
    const above = toneMap([0.8 + 1e-9, 0.3, 1e-4], 0);
    [0.8, 0.3, 1e-4].forEach((value, i) => {
      expect(above[i]).toBeCloseTo(value, 8);
    });
  });

  test('what is far too bright fades to white', () => {
    expect(Math.min(...toneMap([1e5, 1e3, 1e3], 0))).toBeGreaterThan(0.99);
  });
});
