import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { fastestVertex } from '../../src/scene/motion/motion.ts';
import { probeVertices } from '../../src/scene/view/probe.ts';
import { distanceFromLine, mean, objectAt, openExample, speedOfLight, worldPositions } from './open.ts';

const scene = await openExample('wheel');
const c = speedOfLight(scene);
const wheel = objectAt(scene, '/World/Rolling');
const BETA = 0.6;
const GAMMA = 1.25;
const RADIUS = 2;
const SPOKES = 10;
const MIDDLE = 2.9;

const rim = (points: readonly Vec3[], own: readonly Vec3[]): Vec3[] =>
  points.filter((_, i) => Math.hypot(own[i][0], own[i][1]) > RADIUS - 0.02);

/** The wheel on a slice of simultaneity of an observer on the axle: every vertex relative to the axle. */
function inTheAxlesFrame(t: number): Vec3[] {
  const axle: Vec3 = [BETA * c * (t - MIDDLE), RADIUS, 0];
  return probeVertices(wheel, { t, position: axle, u: properVelocity([BETA, 0, 0]) }, c, 'simultaneity').map(
    (p) => p!.apparent,
  );
}

const own = inTheAxlesFrame(MIDDLE);

/** At MIDDLE the first spoke is along x in the axle's frame, and the others at equal angles. */
const STEP = (2 * Math.PI) / SPOKES;

/** For each spoke the centres of its cross sections from hub to rim, of `points`. */
function spokes(points: readonly Vec3[]): Vec3[][] {
  const sections = [0.26, 0.45, 0.85, 1.3, 1.78];
  return Array.from({ length: SPOKES }, (_, s) =>
    sections.map((rho) =>
      mean(
        points.filter((_, i) => {
          const [x, y] = own[i];
          const along = x * Math.cos(s * STEP) + y * Math.sin(s * STEP);
          const aside = y * Math.cos(s * STEP) - x * Math.sin(s * STEP);
          return Math.abs(along - rho) < 0.02 && Math.abs(aside) < 0.09 && Math.abs(own[i][2]) < 0.09;
        }),
      ),
    ),
  );
}
const bend = (spoke: readonly Vec3[]): number =>
  Math.max(...spoke.map((p) => distanceFromLine(p, spoke[0], spoke[spoke.length - 1])));

describe('wheel', () => {
  it('rolls at 0.6 c: the speed of its axle; its top moves at 0.88 c, its bottom is at rest', () => {
    const at = (t: number) => worldPositions(wheel, t, c);
    const hub = (t: number) => mean(at(t).filter((_, i) => Math.hypot(own[i][0], own[i][1]) < 0.2))[0];
    expect((hub(4) - hub(2)) / 2).toBeCloseTo(BETA * c, 1);
    expect(fastestVertex(wheel, c).speed / c).toBeCloseTo((2 * BETA) / (1 + BETA * BETA), 1);
    const [before, after] = [at(2.9 - 1 / 32), at(2.9 + 1 / 32)];
    const feet = before.map((p, i) => ({
      y: p[1],
      speed: (16 * Math.hypot(after[i][0] - p[0], after[i][1] - p[1])) / c,
    }));
    const lowest = feet.filter(({ y }) => y < 0.03);
    expect(lowest.length).toBeGreaterThan(0);
    for (const { speed } of lowest) expect(speed).toBeLessThan(0.2);
  });

  it('is round with straight spokes in the frame of its axle', () => {
    for (const t of [2.5, 2.9, 3.3])
      for (const [x, y] of rim(inTheAxlesFrame(t), own)) expect(Math.abs(Math.hypot(x, y) - RADIUS)).toBeLessThan(0.03);
    for (const spoke of spokes(own)) expect(bend(spoke)).toBeLessThan(0.02);
  });

  it('is an ellipse with bent spokes in the frame of the road', () => {
    const now = worldPositions(wheel, MIDDLE, c);
    const edge = rim(now, own);
    const extent = (k: number) => Math.max(...edge.map((p) => p[k])) - Math.min(...edge.map((p) => p[k]));
    expect(extent(0)).toBeCloseTo((2 * RADIUS) / GAMMA, 1);
    expect(extent(1)).toBeCloseTo(2 * RADIUS, 1);
    const bends = spokes(now).map(bend);
    expect(Math.max(...bends)).toBeGreaterThan(0.1);
    // The spoke along the motion is only shifted, and stays the straightest.
    expect(Math.min(...bends)).toBeLessThan(0.05);
  });

  it('the one on the stand keeps its shape: rotation about an axle at rest changes no radial length', () => {
    const turning = objectAt(scene, '/World/Turning');
    const sizes = [1, 2].map((t) => {
      const points = worldPositions(turning, t, c);
      const middle = mean(points);
      return Math.max(...points.map((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1])));
    });
    for (const size of sizes) expect(size).toBeCloseTo(RADIUS, 1);
  });
});
