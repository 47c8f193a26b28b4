import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  direction,
  expectClose,
  magnitude,
  offset,
  perpendicular,
  properVelocityUpTo,
  uniform,
} from '../../../tests/support/physicsArbitraries.ts';
import {
  add,
  addScaled,
  cross,
  distance,
  dot,
  length,
  negate,
  normalize,
  scale,
  sub,
  type Vec3,
} from '../../math/vec3.ts';
import { gamma, velocity } from '../lorentz/boost.ts';
import { apparentPosition } from '../optics/apparentPosition.ts';
import type { CubicLine } from './kinds/cubicLine.ts';
import type { PolylineLine } from './kinds/polylineLine.ts';
import type { UniformLine } from './kinds/uniformLine.ts';
import type { ObserverEvent } from './kinds/worldLineKind.ts';
import { emissionEvent, emissionOffsets, emissionTime, emissionTimes, newtonEmissionTime } from './lightCone.ts';
import { contraction } from './simultaneity.ts';
import { positionAt, velocityAt, type WorldLine } from './worldLine.ts';

const speedOfLight = magnitude(0, 8.5);
/** Up to ±10⁴ s. */
const time = fc.tuple(fc.constantFrom(-1, 1), magnitude(-6, 4)).map(([s, t]) => s * t);

/** A velocity up to γ = 10 [c]. */
const slow = properVelocityUpTo(10).map(velocity);

/** World lines of every kind, for c = 1 m/s, scaled afterwards. */
const shape: fc.Arbitrary<(c: number) => WorldLine> = fc.oneof(
  offset.map((position) => (): WorldLine => ({ kind: 'static', position })),
  fc.tuple(offset, properVelocityUpTo(1000)).map(
    ([position, u]) =>
      (c: number): WorldLine => ({ kind: 'uniform', position, velocity: scale(velocity(u), c) }),
  ),
  fc.tuple(offset, direction, magnitude(-3, 2), time).map(
    ([position, n, a, t0]) =>
      (c: number): WorldLine => ({ kind: 'hyperbolic', position, properAcceleration: scale(n, a * c), t0 }),
  ),
  fc
    .tuple(offset, direction, magnitude(-1, 1), uniform(0, 0.9999))
    .map(([center, axis, radius, beta]) => (c: number): WorldLine => {
      const arm = scale(normalize(cross(axis, [0.36, 0.48, 0.8]), [1, 0, 0]), radius);
      return { kind: 'circular', center, axis, arm, angularVelocity: (beta * c) / radius };
    }),
  fc
    .tuple(offset, fc.array(fc.tuple(properVelocityUpTo(30), magnitude(-2, 2)), { minLength: 1, maxLength: 9 }), time)
    .map(
      ([start, legs, t0]) =>
        (c: number): WorldLine =>
          walk(start, legs, t0, c),
    ),
  fc.tuple(offset, fc.array(fc.tuple(slow, slow, slow, magnitude(-2, 2)), { minLength: 1, maxLength: 9 }), time).map(
    ([start, legs, t0]) =>
      (c: number): WorldLine =>
        curve(start, legs, t0, c),
  ),
);

/** Pieces given by their control velocities; the velocity may jump between them. */
function curve(start: Vec3, legs: readonly (readonly [Vec3, Vec3, Vec3, number])[], t0: number, c: number): CubicLine {
  const mean = legs.map(([a, b, d, span]) => [scale(add(add(a, b), d), 1 / 3), span] as const);
  const { times, positions } = walkWith(start, mean, t0, c);
  const velocities = Float64Array.from(legs.flatMap(([a, , d]) => [...scale(a, c), ...scale(d, c)]));
  return { kind: 'cubic', times, positions, velocities };
}

const walk = (start: Vec3, legs: readonly (readonly [Vec3, number])[], t0: number, c: number): PolylineLine =>
  walkWith(
    start,
    legs.map(([u, span]) => [velocity(u), span] as const),
    t0,
    c,
  );

function walkWith(start: Vec3, legs: readonly (readonly [Vec3, number])[], t0: number, c: number): PolylineLine {
  const [times, positions] = [[t0], [start]];
  for (const [v, span] of legs) {
    const t = times[times.length - 1];
    times.push(t + span);
    positions.push(addScaled(positions[positions.length - 1], v, c * (t + span - t)));
  }
  return { kind: 'polyline', times: Float64Array.from(times), positions: Float64Array.from(positions.flat()) };
}

const scene = fc
  .tuple(shape, offset, time, speedOfLight)
  .map(([make, position, t, c]) => ({ w: make(c), o: { t, position } as ObserverEvent, c }));

describe('the emission event', () => {
  it('is on the past light cone, to 1e-12 of the lengths involved', () => {
    const kinds = new Set<string>();
    fc.assert(
      fc.property(scene, ({ w, o, c }) => {
        const e = emissionEvent(w, o, c);
        if (!e) return;
        kinds.add(w.kind);
        const size = length(o.position) + length(e.position) + c * (Math.abs(o.t) + Math.abs(e.t));
        expect(e.delay, 'the retarded root').toBeGreaterThanOrEqual(0);
        expectClose(length(e.offset), c * e.delay, 1e-12 * size);
        expectClose(e.t, o.t - e.delay, (1e-15 * size) / c);
        expectClose(sub(e.position, e.offset), o.position, 1e-15 * size);
        if (w.kind === 'circular') return;
        expectClose(positionAt(w, e.t, c), e.position, 1e-12 * size);
      }),
      { numRuns: 1000 },
    );
    expect([...kinds].sort()).toEqual(['circular', 'cubic', 'hyperbolic', 'polyline', 'static', 'uniform']);
  });
  it('is on the circle too, to the accuracy of the angle ωt', () =>
    fc.assert(
      fc.property(scene, ({ w, o, c }) => {
        fc.pre(w.kind === 'circular');
        const e = emissionEvent(w, o, c);
        if (!e) expect.fail('a circle is always seen');
        const size = length(o.position) + length(e.position) + c * (Math.abs(o.t) + Math.abs(e.t));
        expectClose(distance(positionAt(w, e.t, c), e.position), 0, 1e-12 * size);
      }),
    ));
  it('is the observer’s event for an observer on the world line', () =>
    fc.assert(
      fc.property(shape, time, speedOfLight, (make, t, c) => {
        const w = make(c);
        const o = { t, position: positionAt(w, t, c) };
        const size = length(o.position) + c * Math.abs(t) + (w.kind === 'hyperbolic' ? c * Math.abs(w.t0) : 0);
        const late = emissionEvent(w, o, c);
        // For a head-on approach, one rounding of the position delays the event by 2γ² roundings.
        const g = w.kind === 'hyperbolic' ? Math.hypot(1, (length(w.properAcceleration) * (t - w.t0)) / c) : 1000;
        expect(late ? c * late.delay : Number.POSITIVE_INFINITY).toBeLessThanOrEqual(1e-14 * (1 + g * g) * size);
      }),
    ));
  it('agrees with closed forms of simple cases', () => {
    const c = 10;
    const o = { t: 5, position: [0, 0, 0] as Vec3 };
    expect(emissionTime({ kind: 'static', position: [30, 40, 0] }, o, c)).toBe(0);
    // Passing the observer at t = 0 with 0.6 c: t_e = t_o/(1 + β) receding.
    expectClose(emissionTime({ kind: 'uniform', position: [0, 0, 0], velocity: [6, 0, 0] }, o, c) ?? 0, 5 / 1.6, 1e-15);
    // Coming: t_o/(1 − β) before that.
    const before = { t: -5, position: o.position };
    expectClose(
      emissionTime({ kind: 'uniform', position: [0, 0, 0], velocity: [6, 0, 0] }, before, c) ?? 0,
      -12.5,
      1e-14,
    );
  });
  it('does not exist on hyperbolic motion behind the horizon', () => {
    const rocket: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [10, 0, 0], t0: 0 };
    // c²/a = 10 m behind the start; ct < 10 m − x: not yet.
    expect(emissionTime(rocket, { t: 0, position: [-10.001, 0, 0] }, 10)).toBeUndefined();
    expect(emissionTime(rocket, { t: 0, position: [-9.999, 0, 0] }, 10)).toBeLessThan(-100);
    expect([...emissionTimes([rocket], { t: -3, position: [0, 0, 0] }, 10)]).toEqual([Number.NaN]);
    expect([...emissionOffsets([rocket], { t: -3, position: [0, 0, 0] }, 10)]).toEqual([
      Number.NaN,
      Number.NaN,
      Number.NaN,
    ]);
  });
  it('of many lines equals that of each', () =>
    fc.assert(
      fc.property(fc.array(shape, { maxLength: 4 }), offset, time, (makers, position, t) => {
        const lines = makers.map((make) => make(10));
        const o = { t, position };
        const events = lines.map((w) => emissionEvent(w, o, 10));
        const nan = [Number.NaN, Number.NaN, Number.NaN];
        expect([...emissionTimes(lines, o, 10)]).toEqual(events.map((e) => e?.t ?? Number.NaN));
        expect([...emissionOffsets(lines, o, 10)]).toEqual(events.flatMap((e) => [...(e?.offset ?? nan)]));
      }),
    ));
});

describe('a moving body', () => {
  it('looks like one at rest for an observer moving the other way', () =>
    fc.assert(
      fc.property(properVelocityUpTo(50), offset, (u, rest) => {
        // In the body's frame the observer moves with −u and passes the point `rest` when both clocks show 0.
        const w: WorldLine = { kind: 'uniform', position: contraction(rest, u), velocity: scale(velocity(u), 10) };
        const seen = emissionEvent(w, { t: 0, position: [0, 0, 0] }, 10);
        const expected = apparentPosition(rest, negate(u));
        expectClose(seen?.offset ?? [], expected, 1e-13 * gamma(u) ** 2 * length(expected));
      }),
    ));
  it('of spherical shape has a circular outline: its tangent points are seen on a circular cone', () =>
    fc.assert(
      fc.property(properVelocityUpTo(20), direction, uniform(1.1, 20), (u, axis, far) => {
        // Unit sphere, its centre `far` away in its own frame: the tangent points, off the axis by √(1 − 1/far²).
        const radius = Math.sqrt(1 - 1 / far ** 2);
        const seen = [0, 1, 2, 3, 4, 5].map((i) => {
          const rest = addScaled(scale(perpendicular(axis, i), radius), axis, far - 1 / far);
          const w: WorldLine = { kind: 'uniform', position: contraction(rest, u), velocity: scale(velocity(u), 10) };
          return normalize(emissionEvent(w, { t: 0, position: [0, 0, 0] }, 10)?.offset ?? [0, 0, 0]);
        });
        const normal = normalize(cross(sub(seen[2], seen[0]), sub(seen[4], seen[0])));
        const size = Math.max(...seen.map((n) => length(sub(n, seen[0]))));
        for (const n of seen) expectClose(dot(sub(n, seen[0]), normal), 0, 1e-10 * gamma(u) * size);
      }),
    ));
});

describe('polylines', () => {
  /** Samples of uniform motion. */
  const sampled = (w: UniformLine, times: number[]): PolylineLine => ({
    kind: 'polyline',
    times: Float64Array.from(times),
    positions: Float64Array.from(times.flatMap((t) => positionAt(w, t, 1))),
  });
  it('are seen like the uniform motion they sample', () =>
    fc.assert(
      fc.property(offset, properVelocityUpTo(5), offset, time, (position, u, at, t) => {
        const w: UniformLine = { kind: 'uniform', position, velocity: scale(velocity(u), 10) };
        const o = { t, position: at };
        const exact = emissionTime(w, o, 10) ?? Number.NaN;
        const times = [-7, -3, -1, 0.5, 2, 8].map((s) => exact + s);
        const size = length(position) + length(at) + 10 * (Math.abs(t) + Math.abs(exact) + 8);
        expectClose(emissionTime(sampled(w, times), o, 10) ?? Number.NaN, exact, 1e-12 * size);
      }),
    ));
  it('are at rest before the first and after the last sample', () => {
    const line: PolylineLine = {
      kind: 'polyline',
      times: Float64Array.of(0, 10),
      positions: Float64Array.of(0, 0, 0, 50, 0, 0),
    };
    const look = (t: number, x: number) => emissionEvent(line, { t, position: [x, 0, 0] }, 10);
    expect(look(-3, 20)).toMatchObject({ t: -5, position: [0, 0, 0], velocity: [0, 0, 0] });
    expect(look(30, 150)).toMatchObject({ t: 20, position: [50, 0, 0], velocity: [0, 0, 0] });
    expect(look(6, 0)).toMatchObject({ t: 4, position: [20, 0, 0], velocity: [5, 0, 0] });
  });
});

describe('Newton', () => {
  it('converges to the exact event of smooth motion', () =>
    fc.assert(
      fc.property(offset, properVelocityUpTo(3), offset, uniform(-50, 50), (position, u, at, t) => {
        const w: WorldLine = { kind: 'uniform', position, velocity: scale(velocity(u), 10) };
        const o = { t, position: at };
        const exact = emissionTime(w, o, 10) ?? Number.NaN;
        const size = length(position) + length(at) + Math.abs(t) + Math.abs(exact);
        expectClose(newtonEmissionTime(w, o, 10, { iterations: 60, damping: 1 }), exact, 1e-11 * size);
      }),
    ));
  it('is exact at rest in one step, and unchanged without steps', () => {
    const w: WorldLine = { kind: 'static', position: [30, 40, 0] };
    const o = { t: 7, position: [0, 0, 0] as Vec3 };
    expect(newtonEmissionTime(w, o, 10, { iterations: 1, damping: 1 })).toBe(2);
    expect(newtonEmissionTime(w, o, 10, { iterations: 0, damping: 1 })).toBe(7);
  });
  it('leaves (1 − k)ⁿ of the error with damping k, where f is linear', () => {
    const w: WorldLine = { kind: 'static', position: [30, 40, 0] };
    const o = { t: 7, position: [0, 0, 0] as Vec3 };
    for (const damping of [0.1, 0.5, 0.9])
      for (const iterations of [1, 3, 10])
        expectClose(newtonEmissionTime(w, o, 10, { iterations, damping }), 2 + 5 * (1 - damping) ** iterations, 1e-13);
  });
  it('converges quadratically on a curve', () => {
    const w: WorldLine = {
      kind: 'circular',
      center: [40, 0, 0],
      axis: [0, 0, 1],
      arm: [5, 0, 0],
      angularVelocity: 0.5,
    };
    const o = { t: 3, position: [0, 0, 0] as Vec3 };
    const exact = emissionTime(w, o, 10) ?? Number.NaN;
    const errors = [1, 2, 3].map((n) => Math.abs(newtonEmissionTime(w, o, 10, { iterations: n, damping: 1 }) - exact));
    expect(errors[1]).toBeLessThan(errors[0] ** 2);
    expect(errors[2]).toBeLessThan(errors[1] ** 1.5 + 1e-14);
    expect(length(velocityAt(w, exact, 10))).toBeCloseTo(2.5, 12);
  });
  it('does not move from an observer on the world line', () => {
    const w: WorldLine = { kind: 'uniform', position: [0, 0, 0], velocity: [3, 0, 0] };
    expect(newtonEmissionTime(w, { t: 0, position: [0, 0, 0] }, 10, { iterations: 5, damping: 1 })).toBe(0);
  });
});
