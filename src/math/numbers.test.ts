import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { expectClose, uniform } from '../../tests/support/physicsArbitraries.ts';
import { random } from './random.ts';
import { bisect, brent, safeguardedNewton } from './roots.ts';

describe('root finders', () => {
  const cases: [name: string, f: (x: number) => number, a: number, b: number, root: number][] = [
    ['√2', (x) => x * x - 2, 0, 2, Math.SQRT2],
    ['falling', (x) => 2 - x * x, 0, 2, Math.SQRT2],
    ['π', Math.sin, 3, 4, Math.PI],
    ['Dottie', (x) => Math.cos(x) - x, 0, 1, 0.7390851332151607],
    ['steep', (x) => Math.expm1(50 * (x - 0.1)), 0, 1, 0.1],
    ['flat', (x) => (x - 0.3) ** 9, -1, 1, 0.3],
    ['a jump', (x) => (x < 0.25 ? -1 : 1), 0, 1, 0.25],
    ['zero', (x) => x, -1, 3, 0],
    ['at the end', (x) => x - 1, 1, 3, 1],
  ];
  it.each(cases)('find %s', (name, f, a, b, root) => {
    expectClose(bisect(f, a, b), root, 4e-16 * Math.max(1, Math.abs(root)));
    expectClose(brent(f, a, b), root, 1e-15 * Math.max(1, Math.abs(root)));
    expectClose(brent(f, b, a), root, 1e-15 * Math.max(1, Math.abs(root)));
    // Roots with zero slope are excluded.
    if (name === 'flat') return;
    const sign = f(a) <= f(b) ? 1 : -1;
    const slope = (x: number) => (sign * (f(x + 1e-6) - f(x - 1e-6))) / 2e-6;
    expectClose(
      safeguardedNewton((x) => [sign * f(x), slope(x)], a, b, Number.NaN),
      root,
      1e-15 * Math.max(1, Math.abs(root)),
    );
  });
  it('find the root of any increasing cubic, Brent in far fewer steps', () => {
    let [worst, worstNewton] = [0, 0];
    fc.assert(
      fc.property(uniform(-9, 9), uniform(0.01, 9), (root, slope) => {
        let calls = 0;
        const f = (x: number) => {
          calls++;
          return (x - root) * (slope + (x - root) ** 2);
        };
        expectClose(brent(f, -10, 10.5), root, 1e-14);
        worst = Math.max(worst, calls);
        expectClose(bisect(f, -10, 10.5), root, 1e-14);
        calls = 0;
        expectClose(
          safeguardedNewton((x) => [f(x), slope + 3 * (x - root) ** 2], -10, 10.5, 0),
          root,
          1e-14,
        );
        worstNewton = Math.max(worstNewton, calls);
      }),
    );
    expect(worst).toBeLessThan(40);
    expect(worstNewton).toBeLessThan(40);
  });
  it('stop at the tolerance', () => {
    expectClose(
      brent((x) => x * x - 2, 0, 2, 1e-3),
      Math.SQRT2,
      1e-3,
    );
  });
  it('return the end with the smaller |f| if there is no sign change', () => {
    expect(brent((x) => x + 1e-17, 0, 1)).toBe(0);
    expect(brent((x) => x - 2, 0, 1)).toBe(1);
  });
});

describe('random numbers', () => {
  it('depend on the seed only', () => {
    const draw = (seed: number) => Array.from({ length: 5 }, random(seed));
    expect(draw(1)).toEqual(draw(1));
    expect(draw(1)).not.toEqual(draw(2));
    expect(draw(0)).not.toEqual(draw(2 ** 31));
  });
  it('are uniform in [0, 1), and successive ones uncorrelated', () => {
    const next = random(12345);
    const [n, boxes] = [64000, new Array<number>(64).fill(0)];
    for (let i = 0; i < n; i++) {
      const [x, y] = [next(), next()];
      expect(x >= 0 && x < 1).toBe(true);
      boxes[8 * Math.floor(8 * x) + Math.floor(8 * y)]++;
    }
    const chi2 = boxes.reduce((sum, count) => sum + (count - n / 64) ** 2 / (n / 64), 0);
    // 63 degrees of freedom: 99.99 % lie between 26 and 115.
    expect(chi2).toBeGreaterThan(26);
    expect(chi2).toBeLessThan(115);
  });
});
