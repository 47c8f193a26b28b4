import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { area, DIRECT, lambert, lit, look, twoSided } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY, type Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { plane } from '../../scene/mesh/primitives.ts';
import type { AreaLight, LightShaping } from '../../scene/types.ts';

const floor = { mesh: plane(200, 200), material: lambert(1) } as const;
/** E/L at a point of a white floor under the light, c = 1 m/s: the radiance seen there is E/π. */
function received(lamp: AreaLight, [x, y]: readonly [number, number] = [0, 0], samples = 1024, t = 0): number {
  return Math.PI * look(lit([floor], [lamp]), { position: [x, y, 1], t }, [0, 0, -1], DIRECT, samples)[0];
}

/** πF of a parallel rectangle a × b at the height h with a corner above the point. Source: Howell, Catalog of radiation heat transfer, B-3. */
function cornerFactor(a: number, b: number, h: number): number {
  const half = (A: number, B: number) => (A / Math.hypot(1, A)) * Math.atan(B / Math.hypot(1, A));
  return Math.sign(a * b) * 0.5 * (half(Math.abs(a / h), Math.abs(b / h)) + half(Math.abs(b / h), Math.abs(a / h)));
}

describe('irradiance of area lights', () => {
  it('of a rectangle is π times its form factor, near and far', () => {
    fc.assert(
      fc.property(uniform(0.2, 4), uniform(0.2, 4), uniform(0.3, 9), uniform(-3, 3), (width, height, h, x) => {
        const [left, right] = [-width / 2 - x, width / 2 - x];
        const expected = 2 * (cornerFactor(right, height / 2, h) - cornerFactor(left, height / 2, h));
        expect(received(area('rect', [0, 0, h], { width, height }), [x, 0]) / expected).toBeCloseTo(1, 2);
      }),
      { numRuns: 30 },
    );
  });

  it.each([
    [0.5, 0.4],
    [1, 2],
    [0.3, 9],
  ])('of a disk of radius %d, %d m above, is πr²/(r² + d²)', (radius, d) => {
    expect(
      received(area('disk', [0, 0, d], { radius })) / ((Math.PI * radius ** 2) / (radius ** 2 + d ** 2)),
    ).toBeCloseTo(1, 3);
  });

  it('of a long tube is πr/h, of a line (θ + sin θ cos θ)/h', () => {
    const tube = area('cylinder', [0, 0, 2], { radius: 0.5, length: 4000 });
    expect(received(tube, [0, 0], 2 ** 16) / ((Math.PI * 0.5) / 2)).toBeCloseTo(1, 1);
    const theta = Math.atan2(1.5, 2);
    const line = area('cylinder', [0, 0, 2], { radius: 0, length: 3 });
    const expected = (theta + Math.sin(theta) * Math.cos(theta)) / 2;
    expect(received(line) / expected).toBeCloseTo(1, 3);
    const thin = area('cylinder', [0, 0, 2], { radius: 1e-4, length: 3, color: [5000, 5000, 5000] });
    expect(received(thin) / expected).toBeCloseTo(1, 3);
  });

  it('comes from the front side only, and not from caps', () => {
    const turned = (axis: Vec3, angle: number): { motion: AreaLight['motion'] } => ({
      motion: { kind: 'static', pose: { position: [0, 0, 2], orientation: fromAxisAngle(axis, angle) } },
    });
    const over: Vec3 = [1, 0, 0];
    expect(received(area('rect', [0, 0, 2], { width: 1, height: 1, ...turned(over, Math.PI) }))).toBe(0);
    expect(received(area('disk', [0, 0, 2], { radius: 1, ...turned(over, Math.PI) }))).toBe(0);
    expect(received(area('cylinder', [0, 0, 2], { radius: 1, length: 1, ...turned([0, 1, 0], Math.PI / 2) }))).toBe(0);
  });

  it('has a penumbra: half the light where half of it is hidden', () => {
    const sheet = { mesh: twoSided(plane(50, 50)), material: lambert(0) };
    const motion = { kind: 'static', pose: { position: [25, 0, 2], orientation: IDENTITY } } as const;
    const lamp = area('rect', [0, 0, 4], { width: 1, height: 1 });
    const scene = lit([floor, { ...sheet, motion }], [lamp]);
    const half = look(scene, { position: [0, 0, 1] }, [0, 0, -1], DIRECT, 1024)[0] * Math.PI;
    expect(half / received(lamp)).toBeCloseTo(0.5, 2);
  });

  it('is shaped by a cone, and by a focus', () => {
    const spot = (x: number, shaping: LightShaping) =>
      received(area('disk', [0, 0, 2], { radius: 1e-3, shaping }), [x, 0], 1);
    const cone = { inner: 0.3, outer: 0.5, focus: 0 };
    const open = { inner: 2, outer: 2, focus: 0 };
    expect(spot(2 * Math.tan(0.29), cone)).toBeCloseTo(spot(2 * Math.tan(0.29), open), 12);
    expect(spot(2 * Math.tan(0.4), cone) / spot(2 * Math.tan(0.4), open)).toBeCloseTo(0.5, 2);
    expect(spot(2 * Math.tan(0.51), cone)).toBe(0);
    expect(spot(2, { ...open, focus: 3 }) / spot(2, open)).toBeCloseTo(Math.SQRT1_2 ** 3, 3);
  });
});

describe('a moving area light', () => {
  const turn: Quat = fromAxisAngle([0, 0, 1], 0.4);

  it('lights from where it was; small ones with D⁴ LA cos/r²', () => {
    fc.assert(
      fc.property(uniform(-0.9, 0.9), uniform(-3, 3), uniform(1, 3), (v, x, h) => {
        // Light emitted at t = −1 at (x, 0, h) reaches the origin r later and is seen a second after that.
        const r = Math.hypot(x, h);
        const pose = { position: [x + v, 0, h] as const, orientation: turn };
        const lamp = area('rect', [0, 0, 0], {
          width: 2e-4,
          height: 1e-4,
          motion: { kind: 'uniform', pose, velocity: [v, 0, 0] },
        });
        const D = Math.sqrt(1 - v * v) / (1 + (v * x) / r);
        // Its normal is perpendicular to its velocity: h is the same in both frames, the distance is r/D in the light's own frame.
        const cosine = h / (r / D);
        const expected = (D ** 2 * 2e-8 * cosine * (h / r)) / (r / D) ** 2;
        expect(received(lamp, [0, 0], 1, r) / expected).toBeCloseTo(1, 3);
      }),
      { numRuns: 40 },
    );
  });

  it('rotates as it moves: a face turned away is dark', () => {
    const [facing, away] = [IDENTITY, fromAxisAngle([1, 0, 0], Math.PI)];
    const lamp = area('disk', [0, 0, 0], {
      radius: 0.5,
      motion: {
        kind: 'sampled',
        times: Float64Array.of(0, 1),
        poses: Float64Array.of(0, 0, 2, ...facing, 0, 0, 2, ...away),
      },
    });
    expect(received(lamp, [0, 0], 16, 3)).toBeGreaterThan(0.1);
    expect(received(lamp, [0, 0], 16, 4.1)).toBe(0);
  });
});
