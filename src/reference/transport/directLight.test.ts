import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DIRECT, GREY, lambert, lamp, lit, look, twoSided } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { plane } from '../../scene/mesh/primitives.ts';

const floor = { mesh: plane(200, 200), material: lambert(1) } as const;
const origin = { position: [0, 0, 0], orientation: IDENTITY } as const;
/** Radiance reflected at `at`, seen from a metre above at t, c = 1 m/s: light from there is a second old. */
const above = (scene: ReturnType<typeof lit>, t: number, at: Vec3 = [0, 0, 0], samples = 1): number =>
  look(scene, { position: [at[0], at[1], at[2] + 1], t }, [0, 0, -1], DIRECT, samples)[0];

describe('a light at rest', () => {
  it('without size lights with I cos/d²', () => {
    fc.assert(
      fc.property(uniform(-3, 3), uniform(0.5, 4), uniform(0.1, 9), (x, z, intensity) => {
        const light = lamp([x, 0, z], { color: [intensity, intensity, intensity] });
        const d = Math.hypot(x, z);
        expect(above(lit([floor], [light]), 0)).toBeCloseTo((intensity * (z / d)) / d ** 2 / Math.PI, 12);
      }),
      { numRuns: 40 },
    );
  });

  it.each([
    [0, 2, 1],
    [1, 1.5, 0.9],
    [3, 4, 2],
    [-5, 1.2, 1.1],
  ])('a sphere light at (%d, %d) of radius %d lights with πL(r/d)² cos, near and far', (x, z, radius) => {
    const light = lamp([x, 0, z], { radius, color: [2, 2, 2] });
    const d = Math.hypot(x, z);
    expect(above(lit([floor], [light]), 0, [0, 0, 0], 1024) / (2 * (radius / d) ** 2 * (z / d))).toBeCloseTo(1, 3);
  });

  it('has a penumbra: half the light where half of it is hidden', () => {
    // A half plane whose edge is above the origin, between it and the centre of the sphere light.
    const sheet = { mesh: twoSided(plane(50, 50)), material: lambert(0) };
    const half = { ...sheet, motion: { kind: 'static', pose: { ...origin, position: [25, 0, 2] } } } as const;
    const light = lamp([0, 0, 4], { radius: 1, color: [2, 2, 2] });
    const scene = lit([floor, half], [light]);
    expect(above(scene, 0, [0, 0, 0], 1024) / (2 / 16)).toBeCloseTo(0.5, 2);
    expect(above(scene, 0, [4, 0, 0])).toBe(0);
    const d = Math.hypot(4, 4);
    expect(above(scene, 0, [-4, 0, 0], 1024) / (2 * (1 / d) ** 2 * (4 / d))).toBeCloseTo(1, 2);
  });
});

describe('retardation', () => {
  it('a light switched on at t = 0 is seen on the floor after both light travel times', () => {
    const light = lamp([3, 0, 4], { lifetime: { birth: 0, death: 2 } });
    const scene = lit([floor], [light]);
    for (const [t, shines] of [
      [5.999, false],
      [6.001, true],
      [7.999, true],
      [8.001, false],
    ] as const)
      expect(above(scene, t) > 0, `${t}`).toBe(shines);
  });

  it('a moving light lights from where it was, with D⁴ I/r²', () => {
    fc.assert(
      fc.property(uniform(-0.95, 0.95), uniform(-3, 3), uniform(0.5, 3), (v, x, h) => {
        // Light emitted at t = −1 at (x, 0, h) reaches the origin r later and is seen a second after that.
        const r = Math.hypot(x, h);
        const pose = { ...origin, position: [x + v, 0, h] as const };
        const light = lamp([0, 0, 0], { motion: { kind: 'uniform', pose, velocity: [v, 0, 0] } });
        const D = Math.sqrt(1 - v * v) / (1 + (v * x) / r);
        expect(above(lit([floor], [light]), -1 + r + 1) / ((D ** 4 * (h / r)) / r ** 2 / Math.PI)).toBeCloseTo(1, 9);
      }),
      { numRuns: 60 },
    );
  });

  it('a moving sphere light far away equals a point light at its centre', () => {
    const motion = { kind: 'uniform', pose: { ...origin, position: [6, 0, 30] }, velocity: [0.6, 0, 0] } as const;
    const ball = lamp([0, 0, 0], { motion, radius: 0.1, color: [1 / (Math.PI * 0.01), 0, 0] });
    const point = lamp([0, 0, 0], { motion, color: [1, 0, 0] });
    expect(above(lit([floor], [ball]), 20, [0, 0, 0], 256) / above(lit([floor], [point]), 20)).toBeCloseTo(1, 3);
  });

  it('accelerated and sampled lights are found on the past light cone too', () => {
    const a = 0.5;
    // x = (√(1 + a²t²) − 1)/a; at t = 1.5 it is at 1/a (1.25 − 1) = 0.5 with v = 0.6.
    const hyperbolic = {
      kind: 'hyperbolic',
      pose: { ...origin, position: [0, 0, 2] },
      properAcceleration: [a, 0, 0],
      t0: 0,
    } as const;
    const sampled = {
      kind: 'sampled',
      times: Float64Array.of(1, 2),
      poses: Float64Array.of(0.2, 0, 2, 0, 0, 0, 1, 0.8, 0, 2, 0, 0, 0, 1),
    } as const;
    const r = Math.hypot(0.5, 2);
    const D = 0.8 / (1 + (0.6 * 0.5) / r);
    for (const motion of [hyperbolic, sampled])
      expect(above(lit([floor], [lamp([0, 0, 0], { motion })]), 1.5 + r + 1)).toBeCloseTo(
        (D ** 4 * (2 / r)) / r ** 2 / Math.PI,
        9,
      );
  });
});

it.each([-0.7, -0.2, 0.4, 0.9])('an edge hides a part of a sun: %d of its radius to the side', (d) => {
  const [height, radius] = [5, 0.2];
  const sheet = { mesh: twoSided(plane(50, 50)), material: lambert(0) };
  const pose = { ...origin, position: [25, 0, height] } as const;
  const sun = { kind: 'distant', path: '/Sun', direction: [0, 0, -1], color: [2, 2, 2] } as const;
  const wide = { ...sun, angle: 2 * Math.atan(radius / height) };
  const scene = lit([floor, { ...sheet, motion: { kind: 'static', pose } }], [wide]);
  const part = 0.5 + (d * Math.sqrt(1 - d * d) + Math.asin(d)) / Math.PI;
  expect(above(scene, 0, [-d * radius, 0, 0], 4096) / (2 / Math.PI)).toBeCloseTo(part, 1);
  const point = lit([floor, { ...sheet, motion: { kind: 'static', pose } }], [{ ...sun, angle: 0 }]);
  expect(above(point, 0, [-d * radius, 0, 0])).toBeCloseTo(d > 0 ? 2 / Math.PI : 0, 9);
});

describe('a shadow travels at c', () => {
  const [H, h, v, x0] = [3, 1.2, 0.8, -6];
  const point = lamp([0, 0, H]);
  /** A sheet at height h whose front edge is at x = x0 + vt. */
  const sheet = {
    mesh: twoSided(plane(100, 100)),
    material: lambert(0),
    motion: { kind: 'uniform', pose: { ...origin, position: [x0 - 50, 0, h] }, velocity: [v, 0, 0] },
  } as const;
  const scene = lit([floor, sheet], [point]);

  it.each([-4, -1, 0, 2, 5])(
    'its edge reaches x = %d when the light that just missed the edge reaches the floor',
    (x) => {
      // The light to (x, 0, 0) passes the height h at x(1 − h/H), where the edge is at `blocked`; the remaining distance is h/H of the whole.
      const blocked = (x * (1 - h / H) - x0) / v;
      const darkens = blocked + (h / H) * Math.hypot(x, H);
      expect(above(scene, darkens + 1 - 1e-6, [x, 0, 0])).toBeGreaterThan(0);
      expect(above(scene, darkens + 1 + 1e-6, [x, 0, 0])).toBe(0);
    },
  );

  it('in the simultaneity view it is below the edge', () => {
    const settings = { ...GREY, view: 'galilean' as const };
    const at = (t: number) => look(scene, { position: [2, 0, 1], t }, [0, 0, -1], DIRECT, 1, { settings })[0];
    const blocked = (2 * (1 - h / H) - x0) / v;
    expect(at(blocked - 1e-6)).toBeGreaterThan(0);
    expect(at(blocked + 1e-6)).toBe(0);
  });
});
