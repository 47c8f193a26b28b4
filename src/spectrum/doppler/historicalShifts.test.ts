import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../math/vec3.ts';
import { linearSpectrumShift, twoWavelengthShift } from './historicalShifts.ts';

/** Bruton's colours of wavelengths as that program has them, case by case. */
function colorOf(nm: number): Vec3 {
  let [r, g, b] = [0, 0, 0];
  if (nm >= 380 && nm < 440) [r, g, b] = [(440 - nm) / 60, 0, 1];
  else if (nm >= 440 && nm < 490) [r, g, b] = [0, (nm - 440) / 50, 1];
  else if (nm >= 490 && nm < 510) [r, g, b] = [0, 1, (510 - nm) / 20];
  else if (nm >= 510 && nm < 580) [r, g, b] = [(nm - 510) / 70, 1, 0];
  else if (nm >= 580 && nm < 645) [r, g, b] = [1, (645 - nm) / 65, 0];
  else if (nm >= 645 && nm < 780) [r, g, b] = [1, 0, 0];
  let dim = 0;
  if (nm >= 380 && nm < 420) dim = 0.3 + (0.7 * (nm - 380)) / 40;
  else if (nm >= 420 && nm < 700) dim = 1;
  else if (nm >= 700 && nm < 780) dim = 0.3 + (0.7 * (780 - nm)) / 80;
  return [(r * dim) ** 0.8, (g * dim) ** 0.8, (b * dim) ** 0.8];
}

const expectColor = (found: Vec3, wanted: Vec3) => {
  for (const [k, value] of found.entries()) expect(value).toBeCloseTo(wanted[k]!, 9);
};

describe('two wavelengths', () => {
  it('of a colour by hand: an orange is 490 and 645 − 65 (g − b)/r nm', () => {
    const [r, g, b] = [1, 0.5 ** 1.25, 0.2 ** 1.25];
    for (const D of [0.8, 1.2, 1.5]) {
      const [low, high] = [colorOf(490 / D), colorOf((645 - 65 * (g - b)) / D)];
      expectColor(
        twoWavelengthShift([1, 0.5, 0.2], D, 1),
        [0, 1, 2].map((k) => b * low[k]! + r * high[k]!) as unknown as Vec3,
      );
    }
  });

  it('of a magenta, a green and a blue', () => {
    const power = (x: number) => x ** 1.25;
    const sum = (...lines: readonly (readonly [number, number])[]): Vec3 =>
      [0, 1, 2].map((k) =>
        lines.reduce((all, [nm, light]) => all + light * colorOf(nm / 1.1)[k]!, 0),
      ) as unknown as Vec3;
    expectColor(
      twoWavelengthShift([1, 0.3, 0.6], 1.1, 1),
      sum([645, 1], [440 + (50 * power(0.3)) / power(0.6), power(0.6)]),
    );
    expectColor(twoWavelengthShift([0.4, 1, 0.7], 1.1, 1), sum([645, power(0.4)], [510 - 20 * power(0.7), 1]));
    const violet = 440 - 60 * power(0.5);
    const dim = violet < 420 ? 0.3 + (0.7 * (violet - 380)) / 40 : 1;
    expectColor(twoWavelengthShift([0.5, 0.2, 1], 1.1, 1), sum([violet, 1 / dim], [510, power(0.2)]));
  });

  it('errs at rest already, and shows nothing that comes from beyond the visible', () => {
    // Greys stay; the weaker channels of colours do not.
    expectColor(twoWavelengthShift([0.5, 0.5, 0.5], 1, 1), [0.5, 0.5, 0.5]);
    expect(twoWavelengthShift([1, 0.5, 0.2], 1, 1)[2]).toBeCloseTo(0.2 ** 1.25, 9);
    expect(twoWavelengthShift([1, 1, 1], 0.5, 1)).toEqual([0, 0, 0]);
    expect(twoWavelengthShift([0, 0, 0], 1.3, 1)).toEqual([0, 0, 0]);
  });

  it('scales with the light, and follows the mix as a power of D', () => {
    const shift = twoWavelengthShift([0.9, 0.3, 0.1], 1.44, 1);
    expectColor(twoWavelengthShift([90, 30, 10], 1.44, 1), shift.map((x) => 100 * x) as unknown as Vec3);
    expectColor(twoWavelengthShift([0.9, 0.3, 0.1], 1.44 ** 2, 0.5), shift);
  });
});

describe('a linear spectrum', () => {
  const unit = fc.double({ min: 0, max: 1, noNaN: true });
  const shift = fc.double({ min: 0.2, max: 5, noNaN: true });

  it('leaves colours at D = 1, and is linear', () => {
    fc.assert(
      fc.property(unit, unit, unit, shift, (r, g, b, D) => {
        expectColor(linearSpectrumShift([r, g, b], 1, 1), [r, g, b]);
        const parts = (
          [
            [r, 0, 0],
            [0, g, 0],
            [0, 0, b],
          ] as const
        ).map((part) => linearSpectrumShift(part, D, 1));
        expectColor(
          linearSpectrumShift([r, g, b], D, 1),
          [0, 1, 2].map((k) => parts.reduce((sum, part) => sum + part[k]!, 0)) as unknown as Vec3,
        );
      }),
    );
  });

  it('is one spectrum: what red shows at D, green shows at (700/520) D and blue at (700/460) D', () => {
    fc.assert(
      fc.property(unit, unit, unit, shift, (r, g, b, D) => {
        const [seen] = linearSpectrumShift([r, g, b], D, 1);
        expect(linearSpectrumShift([r, g, b], (D * 700) / 520, 1)[1]).toBeCloseTo(seen, 9);
        expect(linearSpectrumShift([r, g, b], (D * 700) / 460, 1)[2]).toBeCloseTo(seen, 9);
      }),
    );
  });

  it('of colours by hand', () => {
    // Infrared of a red, half of it, at 1000 nm, and ultraviolet of a blue at 340 nm.
    expectColor(linearSpectrumShift([1, 0, 0], 1000 / 700, 1), [
      0.5,
      1 - (0.5 * (5200 / 7 - 700)) / 300,
      (4600 / 7 - 520) / 180,
    ]);
    expect(linearSpectrumShift([0, 0, 1], 340 / 460, 1)[2]).toBeCloseTo(0.5, 12);
    // White stays white near D = 1, and falls off beyond the ultraviolet and the infrared.
    const white: Vec3 = [1, 1, 1];
    expectColor(
      linearSpectrumShift(white, 0.5, 1),
      [350, 260, 230].map((at) =>
        at < 340 ? (0.875 * at) / 340 : 0.875 + (0.125 * (at - 340)) / 120,
      ) as unknown as Vec3,
    );
    expectColor(linearSpectrumShift(white, 4, 1), [875 / 2800, 875 / 2080, 875 / 1840]);
  });

  it('follows the mix as a power of D', () => {
    expectColor(linearSpectrumShift([0.9, 0.3, 0.1], 1.44 ** 2, 0.5), linearSpectrumShift([0.9, 0.3, 0.1], 1.44, 1));
  });
});
