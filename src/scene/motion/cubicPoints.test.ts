import { describe, expect, it } from 'vitest';
import { expectClose } from '../../../tests/support/physicsArbitraries.ts';
import { distance, length, type Vec3 } from '../../math/vec3.ts';
import { emissionEvent } from '../../physics/worldLines/lightCone.ts';
import { positionAt, velocityAt } from '../../physics/worldLines/worldLine.ts';
import { makeMaterial, makeObject, makeScene } from '../defaults.ts';
import { plane } from '../mesh/primitives.ts';
import type { Mesh, SceneObject } from '../types.ts';
import { validate } from '../validation/validate.ts';
import {
  bendFactor,
  type CubicPointsMotion,
  estimateChordError,
  maxControlSpeed,
  parabolaVelocities,
  straightenedPieces,
} from './cubicPoints.ts';
import { fastestVertex, vertexPositions, vertexWorldLine } from './motion.ts';

const C = 10;

/** Points in f64, to avoid rounding. */
const exact = (points: readonly number[]): Float32Array => Float64Array.from(points) as unknown as Float32Array;

/** A sheet whose corners move along `path`, with `n` samples in a second. */
function sheet(n: number, path: (t: number, i: number) => Vec3, cubic = true): SceneObject {
  const mesh: Mesh = plane(1, 1, 'Z');
  const times = Float64Array.from({ length: n + 1 }, (_, k) => k / n);
  const points = Array.from(times, (t) => exact([0, 1, 2, 3].flatMap((i) => [...path(t, i)])));
  const velocities = cubic ? { velocities: parabolaVelocities(times, points) } : {};
  return makeObject({
    path: '/Sheet',
    mesh,
    motion: { kind: 'sampled-points', times, origin: [1, 2, 3], points, ...velocities },
  });
}

const circle = (t: number, i: number): Vec3 => [Math.cos(2 * Math.PI * t + i), Math.sin(2 * Math.PI * t + i), 0];

/** Greatest distance of vertex 1 from its circle between the samples, away from the ends. */
function error(object: SceneObject): number {
  const line = vertexWorldLine(object, 1, C);
  const ts = Array.from({ length: 997 }, (_, k) => 0.3 + (0.4 * k) / 997);
  const at = (t: number) => distance(positionAt(line, t, C), [1 + circle(t, 1)[0], 2 + circle(t, 1)[1], 3]);
  return Math.max(...ts.map(at));
}

describe('a circle from n samples', () => {
  it('is approximated better by cubics: their error falls at least as n⁻³, that of chords as n⁻²', () => {
    const cubic = [12, 24, 48].map((n) => error(sheet(n, circle)));
    const chords = [12, 24, 48].map((n) => error(sheet(n, circle, false)));
    for (const k of [0, 1]) {
      expect(cubic[k] / cubic[k + 1]).toBeGreaterThan(7);
      expect(chords[k] / chords[k + 1]).toBeGreaterThan(3.6);
      expect(chords[k] / chords[k + 1]).toBeLessThan(4.4);
    }
    expect(chords[2] / cubic[2]).toBeGreaterThan(30);
  });
  it('with its true velocities as n⁻⁴', () => {
    const errors = [12, 24, 48].map((n) => {
      const object = sheet(n, circle);
      if (object.motion.kind !== 'sampled-points') return Number.NaN;
      const { times } = object.motion;
      const turning = (t: number, i: number) => [-circle(t, i)[1], circle(t, i)[0], 0].map((x) => 2 * Math.PI * x);
      const velocities = Array.from(times, (t) => exact([0, 1, 2, 3].flatMap((i) => turning(t, i))));
      return error({ ...object, motion: { ...object.motion, velocities } });
    });
    expect(errors[0] / errors[1]).toBeGreaterThan(15);
    expect(errors[1] / errors[2]).toBeGreaterThan(15);
  });
  it('has a continuous velocity at samples, unlike chords', () => {
    const jump = (object: SceneObject): number => {
      const line = vertexWorldLine(object, 1, C);
      const at = (t: number) => emissionEvent(line, { t, position: [9, 2, 3] }, C)?.velocity ?? [0, 0, 0];
      const ts = Array.from({ length: 2000 }, (_, k) => 1.2 + (0.4 * k) / 2000);
      return Math.max(...ts.map((t) => distance(at(t), at(t + 2e-4))));
    };
    // At most the acceleration times the time between: 4π² · 2·10⁻⁴, nearer by the Doppler factor.
    expect(jump(sheet(24, circle))).toBeLessThan(0.06);
    expect(jump(sheet(24, circle, false))).toBeGreaterThan(1);
  });
});

it('the vertices at a time are those of the world lines', () => {
  const object = sheet(7, circle);
  for (const t of [-1, 0, 0.33, 0.5, 1, 2]) {
    const lines = [0, 1, 2, 3].flatMap((i) => [...positionAt(vertexWorldLine(object, i, C), t, C)]);
    expectClose([...vertexPositions(object, t, C)], lines, 1e-14);
  }
});

describe('speed', () => {
  const motionOf = (object: SceneObject): CubicPointsMotion => object.motion as CubicPointsMotion;

  it('of the fastest point is the maximum over all times', () => {
    const object = sheet(6, (t, i) => [Math.sin(5 * t + i), Math.cos(7 * t), t * t * i]);
    const found = fastestVertex(object, C);
    const line = vertexWorldLine(object, found.vertex, C);
    const speeds = Array.from({ length: 20001 }, (_, k) => length(velocityAt(line, k / 20000, C)));
    expectClose(found.speed, Math.max(...speeds), 1e-6 * found.speed);
    const k = motionOf(object).times.indexOf(found.from);
    expect(maxControlSpeed(motionOf(object), k)).toBeGreaterThanOrEqual(found.speed);
  });

  /** Rest, a burst at 0.9 c, rest: the parabolas through its samples would exceed c. */
  const dash = sheet(4, (t, i) => [t <= 0.25 ? 0 : t >= 0.75 ? 4.5 : 9 * (t - 0.25), i, 0]);
  const still = sheet(4, (t, i) => [t, i, 0]);

  it('never reaches c: the bend of a piece is reduced, and this is reported', () => {
    expect(straightenedPieces(motionOf(dash), 30)).toEqual([]);
    const faster = {
      ...motionOf(dash),
      points: motionOf(dash).points.map((p) => exact([...p].map((x, i) => (i % 3 === 0 ? 1.08 * x : x)))),
    };
    const quick = {
      ...faster,
      velocities: parabolaVelocities(faster.times, faster.points).map((v) => v.map((x) => 1.3 * x)),
    };
    const object = { ...dash, motion: quick };
    expect(straightenedPieces(quick, C).map(({ k }) => k)).not.toEqual([]);
    expect(fastestVertex(object, C).speed).toBeLessThanOrEqual(0.999 * C * (1 + 1e-9));
    expect(fastestVertex(object, C).speed).toBeGreaterThan(0.97 * C);
    const scene = makeScene({
      name: 'dash',
      objects: [object, { ...still, path: '/Still' }],
      materials: [makeMaterial({ name: 'm' })],
    });
    expect(validate(scene, C).map(({ severity, code, place }) => [severity, code, place])).toEqual([
      ['warning', 'motion.cubic', '/Sheet'],
    ]);
    expect(validate(scene, 2 * C)).toEqual([]);
  });

  it('keeps the full bend at one c and less at another, in any order', () => {
    const motion = motionOf(dash);
    const slow = [0, 1, 2, 3].map((k) => bendFactor(motion, k, 9.2));
    expect([0, 1, 2, 3].map((k) => bendFactor(motion, k, 30))).toEqual([1, 1, 1, 1]);
    expect([0, 1, 2, 3].map((k) => bendFactor(motion, k, 9.2))).toEqual(slow);
    expect(Math.min(...slow)).toBeLessThan(1);
  });

  it('is an error if the chord itself is too fast', () => {
    const scene = makeScene({ name: 'dash', objects: [dash], materials: [makeMaterial({ name: 'm' })] });
    expect(validate(scene, 8).map(({ code }) => code)).toEqual(['motion.superluminal']);
  });
});

describe('the gap between cubics and chords', () => {
  // Of x = t² every cubic is the parabola itself, h²/4 from its chord in the middle.
  const times = Float64Array.of(0, 0.5, 1.5, 3.5, 5);
  const fallen = (points: number) =>
    Array.from(times, (t) => Float32Array.from({ length: 3 * points }, (_, i) => (i % 3 === 1 ? 7 - t * t : 1e5)));
  it('is h²/4 for falling points, in the longest piece, for any number of points', () => {
    expect(estimateChordError(times, fallen(4))).toBeCloseTo(1, 6);
    // More than are examined.
    expect(estimateChordError(times, fallen(300_000))).toBeCloseTo(1, 6);
  });
  it('is h/8 times the change of velocity over a piece', () => {
    const points = Array.from(times, (t) => Float32Array.from({ length: 30 }, (_, i) => Math.sin(i + (1 + i / 9) * t)));
    const velocities = parabolaVelocities(times, points);
    const gaps = velocities.slice(1).flatMap((after, k) =>
      Array.from({ length: 10 }, (_, p) => {
        const change = [0, 1, 2].map((j) => after[3 * p + j] - velocities[k][3 * p + j]);
        return ((times[k + 1] - times[k]) / 8) * Math.hypot(...change);
      }),
    );
    expect(estimateChordError(times, points)).toBeCloseTo(Math.max(...gaps), 5);
  });
  it('ignores points with non-finite coordinates', () => {
    const points = fallen(4);
    points[1].fill(Number.POSITIVE_INFINITY, 6, 9);
    points[3][10] = Number.NaN;
    expect(estimateChordError(times, points)).toBeCloseTo(1, 6);
  });
  it('is 0 at rest, and for two samples', () => {
    const [first, , , , last] = fallen(4);
    expect(estimateChordError(times, Array(5).fill(last))).toBe(0);
    expect(estimateChordError(Float64Array.of(0, 5), [first, last])).toBe(0);
  });
});
