import { describe, expect, it } from 'vitest';
import { length, normalize, scale, sub, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { dopplerFactor } from '../../src/physics/optics/doppler.ts';
import { fastestVertex } from '../../src/scene/motion/motion.ts';
import type { SphereLight } from '../../src/scene/types.ts';
import { observedColor } from '../../src/spectrum/color/observerColor.ts';
import { colorMatching } from '../../src/spectrum/observer/standardObserver.ts';
import { WHITE_FILTER } from '../../src/spectrum/reflectance/spectralFilter.ts';
import { objectAt, openExample, speedOfLight } from './open.ts';

const scene = await openExample('lamps');
const c = speedOfLight(scene);
const lamp = (name: string): SphereLight => {
  const found = scene.lights.find(({ path }) => path.includes(`${name}Light`));
  if (found?.kind !== 'sphere') throw new Error(`no lamp ${name}`);
  return found;
};
const sodium = lamp('Sodium');

/** Samples of a lamp's motion: times [s], positions, and velocities [c] in between. */
function samplesOf({ motion }: SphereLight): { t: number; place: Vec3; beta: Vec3 }[] {
  if (motion.kind !== 'sampled') throw new Error('a lamp shuttles');
  const place = (k: number): Vec3 => [motion.poses[7 * k], motion.poses[7 * k + 1], motion.poses[7 * k + 2]];
  return [...motion.times].slice(1).map((t, k) => ({
    t,
    place: place(k),
    beta: scale(sub(place(k + 1), place(k)), 1 / (c * (t - motion.times[k]))),
  }));
}

describe('lamps', () => {
  it('has sodium, mercury and hydrogen, with the lines of the light presets', () => {
    const lines = ['Sodium', 'Mercury', 'Hydrogen'].map((name) => lamp(name).spectrum);
    expect(lines.map((s) => (s?.kind === 'lines' ? s.lines.length : 0))).toEqual([2, 9, 9]);
  });

  it('moves them at 0.32 c, with a standstill at the ends', () => {
    for (const name of ['Sodium', 'Mercury', 'Hydrogen'])
      expect(fastestVertex(objectAt(scene, `/World/${name}`), c).speed / c, name).toBeCloseTo(0.32, 2);
    const ends = samplesOf(sodium).filter(({ beta }) => length(beta) < 0.01);
    expect(ends.map(({ place }) => Math.abs(place[0])).every((x) => x > 5.9)).toBe(true);
    expect(ends.length).toBeGreaterThan(10);
  });

  // λ′ = λ/D, D = √(1−β²)/(1−β cos α) for light emitted at α to the velocity; visibility from the CIE table only.
  it('lights the wall in blue, green, yellow and red, and then invisibly', () => {
    const fast = samplesOf(sodium).find(({ beta }) => beta[0] > 0.319)!;
    const beta = length(fast.beta);
    const seenAt = (ahead: number): { nm: number; color: Vec3 } => {
      const toLamp = normalize([-ahead, 0, fast.place[2]]);
      const D = dopplerFactor(toLamp, ZERO, scale(fast.beta, 1 / Math.sqrt(1 - beta * beta)));
      const cos = ahead / Math.hypot(ahead, fast.place[2]);
      expect(D).toBeCloseTo(Math.sqrt(1 - beta * beta) / (1 - beta * cos), 10);
      return { nm: 589.2 / D, color: observedColor(WHITE_FILTER, WHITE_FILTER, sodium.spectrum!, 1, D) };
    };
    const eye = (nm: number): Vec3 => colorMatching(nm * 1e-9);
    const blue = seenAt(3);
    expect(blue.nm).toBeLessThan(440);
    expect(eye(blue.nm)[2]).toBeGreaterThan(4 * Math.max(eye(blue.nm)[0], eye(blue.nm)[1]));
    expect(blue.color[2]).toBeGreaterThan(4 * Math.max(blue.color[0], blue.color[1]));
    const green = seenAt(0.38);
    expect(green.nm).toBeGreaterThan(510);
    expect(green.nm).toBeLessThan(560);
    expect(green.color[1]).toBeGreaterThan(3 * Math.max(green.color[0], green.color[2]));
    const yellow = seenAt(0.14);
    expect(yellow.nm).toBeGreaterThan(570);
    expect(yellow.nm).toBeLessThan(600);
    expect(yellow.color[0] / yellow.color[1]).toBeGreaterThan(0.7);
    expect(yellow.color[2]).toBeLessThan(0);
    const red = seenAt(-0.25);
    expect(red.nm).toBeGreaterThan(620);
    expect(red.color[0]).toBeGreaterThan(5 * Math.abs(red.color[1]));
    const gone = seenAt(-3);
    expect(gone.nm).toBeGreaterThan(780);
    expect(Math.max(...gone.color)).toBeLessThan(1e-3);
  });
});
