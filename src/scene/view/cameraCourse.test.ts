import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { addScaled, distance, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { controlVelocities, cubicAt } from '../../physics/worldLines/cubicPiece.ts';
import { cubicPiece } from '../../physics/worldLines/kinds/cubicLine.ts';
import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import { positionAt } from '../../physics/worldLines/worldLine.ts';
import type { SampledMotion } from '../types.ts';
import { smoothCourse } from './cameraCourse.ts';

const C = 10;

function through(times: readonly number[], places: readonly Vec3[]): SampledMotion {
  const poses = places.flatMap((place) => [...place, 0, 0, 0, 1]);
  return { kind: 'sampled', times: Float64Array.from(times), poses: Float64Array.from(poses) };
}

const around = (turns: number, samples: number, radius = 1): SampledMotion => {
  const times = Array.from({ length: samples + 1 }, (_, k) => k / samples);
  const place = (t: number): Vec3 => [
    radius * Math.cos(2 * Math.PI * turns * t),
    0,
    radius * Math.sin(2 * Math.PI * turns * t),
  ];
  return through(times, times.map(place));
};

/** Samples whose straight pieces are slower than light. */
const samples = fc
  .array(
    fc.record({
      span: fc.double({ min: 0.1, max: 2, noNaN: true }),
      beta: fc.oneof(fc.constant(0), fc.double({ min: 0, max: 0.95, noNaN: true })),
      angle: fc.double({ min: 0, max: 2 * Math.PI, noNaN: true }),
      height: fc.double({ min: -1, max: 1, noNaN: true }),
    }),
    { minLength: 2, maxLength: 12 },
  )
  .map((steps) => {
    let [t, place] = [0, [0, 0, 0] as Vec3];
    const [times, places] = [[t], [place]];
    for (const { span, beta, angle, height } of steps) {
      const flat = Math.sqrt(1 - height * height);
      t += span;
      place = addScaled(place, [flat * Math.cos(angle), height, flat * Math.sin(angle)], beta * C * span);
      times.push(t);
      places.push(place);
    }
    return { times, places };
  });

/** Velocities, and accelerations, just before and after the sample k. */
function aroundSample(course: NonNullable<ReturnType<typeof smoothCourse>>, k: number) {
  const [before, after] = [cubicPiece(course.line, k - 1), cubicPiece(course.line, k)];
  // x″ at the ends of a cubic: (2va + 4vb − 6V)/h and (6V − 4va − 2vb)/h.
  const chord = ({ a, b, span }: typeof before) => scale(sub(b, a), 1 / span);
  const ending = addScaled(addScaled(scale(before.va, 2), before.vb, 4), chord(before), -6);
  const beginning = addScaled(addScaled(scale(chord(after), 6), after.va, -4), after.vb, -2);
  return {
    velocities: [before.vb, after.va] as const,
    accelerations: [scale(ending, 1 / before.span), scale(beginning, 1 / after.span)] as const,
  };
}

describe('the course of a camera', () => {
  it('goes through all samples, slower than light, and what jumps is told', () => {
    fc.assert(
      fc.property(samples, ({ times, places }) => {
        const course = smoothCourse(through(times, places), C)!;
        for (const [k, place] of places.entries())
          expect(distance(positionAt(course.line, times[k]!, C), place)).toBeLessThan(1e-9);
        for (let k = 0; k + 1 < times.length; k++)
          for (const v of controlVelocities(cubicPiece(course.line, k))) expect(length(v)).toBeLessThan(C);
        for (let k = 1; k + 1 < times.length; k++) {
          const [before, after] = aroundSample(course, k).velocities;
          const jump = distance(before, after);
          if (course.jumps.includes(times[k]!)) expect(jump).toBeGreaterThan(0);
          else expect(jump).toBeLessThan(1e-7);
        }
      }),
      { numRuns: 300 },
    );
  });

  it('has a continuous acceleration where nothing is fast or rests', () => {
    const course = smoothCourse(around(0.7, 24), 1000)!;
    for (let k = 1; k < 24; k++) {
      const [before, after] = aroundSample(course, k).accelerations;
      expect(distance(before, after)).toBeLessThan(1e-9 * length(before));
    }
    expect(course.jumps).toEqual([]);
  });

  it('is the same backwards', () => {
    fc.assert(
      fc.property(samples, ({ times, places }) => {
        const end = times.at(-1)!;
        const forth = smoothCourse(through(times, places), C)!.line.velocities;
        const reversed = through(times.map((t) => end - t).reverse(), [...places].reverse());
        const back = smoothCourse(reversed, C)!.line.velocities;
        const count = times.length - 1;
        for (let k = 0; k < count; k++)
          for (const [i, j] of [
            [0, 3],
            [3, 0],
          ] as const)
            for (const axis of [0, 1, 2])
              expect(back[6 * (count - 1 - k) + j + axis]).toBeCloseTo(-forth[6 * k + i + axis]!, 6);
      }),
    );
  });

  it('comes to a circle with the fourth power of the time between samples', () => {
    // Away from its ends, where a circle's acceleration is not 0.
    const error = (count: number): number => {
      const { line } = smoothCourse(around(1, count), 1e4)!;
      const at = Array.from({ length: 101 }, (_, i) => 0.4 + 0.002 * i);
      return Math.max(...at.map((t) => Math.abs(length(positionAt(line, t, 1e4)) - 1)));
    };
    const ratio = error(32) / error(64);
    expect(ratio).toBeGreaterThan(13);
    expect(ratio).toBeLessThan(19);
  });

  it('has a clock that goes as on the circle', () => {
    const radius = 0.8;
    const { line } = smoothCourse(around(1, 64, radius), C)!;
    const beta = (2 * Math.PI * radius) / C;
    expect(properTimeBetween(line, 0.25, 0.75, C)).toBeCloseTo(0.5 * Math.sqrt(1 - beta * beta), 6);
  });

  it('rests where the camera rests, and stays beside a cut', () => {
    const places: Vec3[] = [0, 0.1, 0.2, 0.2, 0.2, 0.3, 50, 50.1, 50.2].map((x) => [x, 0, 0]);
    const { line } = smoothCourse(
      through(
        places.map((_, k) => k),
        places,
      ),
      1e6,
    )!;
    for (let t = 2; t <= 4; t += 0.1) expect(positionAt(line, t, 1e6)[0]).toBeCloseTo(0.2, 12);
    for (let t = 0; t < 8; t += 0.05) {
      const [x] = positionAt(line, t, 1e6);
      const [low, high] = [places[Math.floor(t)]![0], places[Math.min(8, Math.floor(t) + 1)]![0]];
      expect(x).toBeGreaterThan(low - 1e-9);
      expect(x).toBeLessThan(high + 1e-9);
    }
  });

  it('is straight where light leaves no room for a curve, and says so', () => {
    const places: Vec3[] = [0, 0, 9, 9].map((x) => [x, 0, 0]);
    const course = smoothCourse(through([0, 1, 2, 3], places), C)!;
    expect(course.jumps).toEqual([1, 2]);
    const { x, v } = cubicAt(cubicPiece(course.line, 1), 0.5);
    expect(x[0]).toBeCloseTo(4.5, 9);
    expect(Math.hypot(...v)).toBeLessThan(C);
  });

  it('keeps what is uniform, and is for samples only', () => {
    const uniform = through(
      [0, 1, 3, 4],
      [0, 1, 3, 4].map((t): Vec3 => [9.99 * t, 0, 0]),
    );
    const course = smoothCourse(uniform, C)!;
    expect(course.strayed).toBeLessThan(1e-12);
    expect(course.jumps).toEqual([]);
    expect(
      smoothCourse(
        through(
          [0, 1],
          [
            [0, 0, 0],
            [1, 0, 0],
          ],
        ),
        C,
      ),
    ).toBeUndefined();
    const pose = { position: [0, 0, 0], orientation: [0, 0, 0, 1] } as const;
    expect(smoothCourse({ kind: 'uniform', pose, velocity: [1, 0, 0] }, C)).toBeUndefined();
  });
});
