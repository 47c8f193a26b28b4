import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { direction, expectClose, uniform } from '../../../../tests/support/physicsArbitraries.ts';
import { add, addScaled, cross, dot, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { SpacetimeTriangle } from './spacetimeTriangle.ts';

const vector = fc.tuple(direction, uniform(0.2, 2)).map(([n, r]) => scale(n, r));
const three = fc.tuple(vector, vector, vector);

function set(corners: readonly Vec3[], rates: readonly Vec3[]): SpacetimeTriangle {
  const triangle = new SpacetimeTriangle();
  triangle.a.set(corners.flat());
  triangle.b.set(rates.flat());
  return triangle;
}

describe('a triangle whose corners move straight', () => {
  it('is hit where one of its points meets the ray', () =>
    fc.assert(
      fc.property(three, three, uniform(0, 3), uniform(0.01, 0.98), uniform(0.01, 0.99), (ends, rates, at, v, part) => {
        const w = (1 - v) * part;
        const middle = add(add(scale(ends[0], 1 - v - w), scale(ends[1], v)), scale(ends[2], w));
        const there = ends.map((p) => sub(p, middle));
        const start = there.map((p, i) => sub(p, scale(rates[i], at)));
        const N = cross(sub(there[1], there[0]), sub(there[2], there[0]));
        const passes = add(add(scale(rates[0], 1 - v - w), scale(rates[1], v)), scale(rates[2], w));
        // Neither degenerate nor hit edge on.
        fc.pre(dot(N, N) > 1e-4 && Math.abs(dot(N, passes)) > 1e-2);
        const triangle = set(start, rates);
        const n = triangle.intersect(3, 1e-13);
        const k = Array.from({ length: n }, (_, i) => Math.abs(triangle.sigma[i] - at) < 1e-8).indexOf(true);
        if (k < 0) return expect.fail(`${n} crossings, none at ${at}`);
        expectClose([triangle.v[k], triangle.w[k]], [v, w], 1e-6);
        // f rises where the plane recedes along its normal: the ray comes from the front.
        expect(triangle.front[k]).toBe(dot(N, passes) > 0);
        expect([...triangle.sigma.subarray(0, n)]).toEqual([...triangle.sigma.subarray(0, n)].sort((p, q) => p - q));
      }),
      { numRuns: 500 },
    ));

  it('is hit each time it sweeps over the ray', () => {
    const rates: Vec3[] = [
      [-8, -1, -7],
      [-4, 5, 1],
      [5, 2, 2],
    ];
    const start: Vec3[] = [
      [5, 0, 5],
      [-3, -4, -1],
      [-1, 0, -1],
    ];
    const corners = start.map((p, i) => addScaled(p, rates[i], -0.1));
    const f = (s: number) => {
      const [p, q, r] = corners.map((c, i) => add(c, scale(rates[i], s)));
      return dot(p, cross(sub(q, p), sub(r, p)));
    };
    let signs = 0;
    for (let i = 0; i < 30000; i++) if (f(i / 10000) < 0 !== f((i + 1) / 10000) < 0) signs++;
    const triangle = set(corners, rates);
    const n = triangle.intersect(3, 1e-13);
    expect(signs).toBe(3);
    expect(n).toBe(signs);
    for (let i = 0; i < n; i++) expectClose(f(triangle.sigma[i]), 0, 1e-11);
  });

  it('is hit where it arrives at the end of the interval', () => {
    const triangle = set(
      [
        [-1, -1, 1],
        [3, -1, 1],
        [-1, 3, 1],
      ],
      [
        [0, 0, -1],
        [0, 0, -1],
        [0, 0, -1],
      ],
    );
    expect(triangle.intersect(1, 1e-13)).toBe(1);
    expectClose([triangle.sigma[0], triangle.v[0], triangle.w[0]], [1, 0.25, 0.25], 1e-12);
    expect(triangle.intersect(1 - 1e-9, 1e-13), 'and not before').toBe(0);
  });

  it('is not hit where it has no area, nor beside it', () => {
    const line = set([ZERO, [1, 0, 0], [2, 0, 0]], [ZERO, ZERO, ZERO]);
    expect(line.intersect(1, 1e-13)).toBe(0);
    const beside = set(
      [
        [1, 1, 1],
        [2, 1, 1],
        [1, 2, 1],
      ],
      [
        [0, 0, -2],
        [0, 0, -2],
        [0, 0, -2],
      ],
    );
    expect(beside.intersect(1, 1e-13)).toBe(0);
  });
});
