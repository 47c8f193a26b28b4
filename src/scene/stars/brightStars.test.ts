import { describe, expect, test } from 'vitest';
import { brightStars, illuminanceOf, temperatureOf } from './brightStars.ts';

/** Norton's Star Atlas, and Wikipedia for temperatures: sources independent of XHIP and Ballesteros. */
const KNOWN = [
  { name: 'Sirius', hours: 6 + 45 / 60 + 9 / 3600, degrees: -(16 + 43 / 60), magnitude: -1.46, kelvin: 9940 },
  { name: 'Vega', hours: 18 + 36 / 60 + 56 / 3600, degrees: 38 + 47 / 60, magnitude: 0.03, kelvin: 9600 },
  { name: 'Betelgeuse', hours: 5 + 55 / 60 + 10 / 3600, degrees: 7 + 24 / 60, magnitude: 0.5, kelvin: 3600 },
  { name: 'Polaris', hours: 2 + 31 / 60 + 49 / 3600, degrees: 89 + 16 / 60, magnitude: 1.98, kelvin: 6015 },
  { name: 'Antares', hours: 16 + 29 / 60 + 24 / 3600, degrees: -(26 + 26 / 60), magnitude: 1.06, kelvin: 3660 },
] as const;

describe('the bright stars', () => {
  const { directions, illuminances, temperatures } = brightStars();

  test.each(KNOWN)('$name has the position, magnitude and temperature of other sources', (star) => {
    const [alpha, delta] = [(star.hours * Math.PI) / 12, (star.degrees * Math.PI) / 180];
    const toward = [Math.cos(delta) * Math.cos(alpha), Math.cos(delta) * Math.sin(alpha), Math.sin(delta)];
    const cosine = (i: number): number => toward.reduce((sum, x, k) => sum + x * directions[3 * i + k], 0);
    const near = Array.from(illuminances.keys()).filter((i) => cosine(i) > Math.cos(0.001));
    expect(near).toHaveLength(1);
    expect(Math.abs(2.5 * Math.log10(illuminances[near[0]] / illuminanceOf(star.magnitude)))).toBeLessThan(0.15);
    expect(Math.abs(temperatures[near[0]] / star.kelvin - 1)).toBeLessThan(0.15);
  });

  test('are those visible to the eye, brightest first, as unit directions', () => {
    expect(illuminances.length).toBeGreaterThan(4900);
    illuminances.forEach((lux, i) => {
      expect(lux).toBeLessThanOrEqual(illuminances[Math.max(i - 1, 0)]);
      expect(Math.hypot(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2])).toBeCloseTo(1, 6);
    });
  });

  // Counts of uniformly strewn stars grow as 10^0.6m; dust and the thin disk make it 10^0.5m (Allen, §19.3).
  test('their number grows with magnitude as in star counts', () => {
    const brighter = (magnitude: number): number => illuminances.filter((lux) => lux > illuminanceOf(magnitude)).length;
    expect(Math.log10(brighter(6) / brighter(3)) / 3).toBeCloseTo(0.5, 1);
  });
});

// Vega, magnitude 0, gives 2.5 · 10⁻⁶ lx; the Sun (B − V = 0.65) is 5800 K.
test('magnitudes and colours agree with textbooks', () => {
  expect(illuminanceOf(0)).toBeCloseTo(2.54e-6, 7);
  expect(illuminanceOf(5) / illuminanceOf(0)).toBeCloseTo(0.01, 12);
  expect(Math.abs(temperatureOf(0.65) - 5772)).toBeLessThan(120);
});
