import { describe, expect, it } from 'vitest';
import { dot, length, normalize, sub, type Vec3 } from '../../src/math/vec3.ts';
import { fastestVertex } from '../../src/scene/motion/motion.ts';
import type { Material, RigidMotion, SphereLight } from '../../src/scene/types.ts';
import { LUMINANCE_WEIGHTS, observedColor } from '../../src/spectrum/color/observerColor.ts';
import { filterFromRgb, WHITE_FILTER } from '../../src/spectrum/reflectance/spectralFilter.ts';
import { objectAt, openExample, ridden, speedOfLight } from './open.ts';

const scene = await openExample('prism');
const c = speedOfLight(scene);
const lamps = scene.lights.filter((light): light is SphereLight => light.kind === 'sphere');
const lampOf = (name: string): SphereLight => lamps.find(({ path }) => path.includes(name))!;

const material = (name: string): Material => scene.materials.find((m) => m.name.endsWith(name))!;
const bands = ({ baseColor, uv, ir }: Material) => filterFromRgb(baseColor, uv, ir);

/** Position and motion of a chart at the emission of light seen at openAt: 0 = t − t_e − |x(t_e) − x_o|/c, by bisection. */
function seen(name: string): { beta: number; D: number } {
  const { motion } = objectAt(scene, `/World/${name}`);
  if (motion.kind === 'sampled-points') throw new Error('charts are rigid');
  const t = scene.hints.openAt!;
  const eye = ridden(scene).reduce((a, b) => (Math.abs(b.t - t) < Math.abs(a.t - t) ? b : a)).position;
  let [early, late] = [t - 12, t];
  for (let i = 0; i < 60; i++) {
    const middle = (early + late) / 2;
    if (t - middle > length(sub(place(motion, middle), eye)) / c) early = middle;
    else late = middle;
  }
  const [a, b] = [place(motion, early - 0.02), place(motion, early + 0.02)];
  const v = sub(b, a).map((x) => x / (0.04 * c)) as unknown as Vec3;
  const beta = dot(v, normalize(sub(eye, a)));
  // Nearly towards the observer: D = √(1−v²)/(1−v·n).
  return { beta, D: Math.sqrt(1 - dot(v, v)) / (1 - beta) };
}

function place(motion: RigidMotion, t: number): Vec3 {
  if (motion.kind !== 'sampled') return 'pose' in motion ? motion.pose.position : [0, 0, 0];
  const { times, poses } = motion;
  const k = Math.max(0, Math.min(times.length - 2, times.findIndex((x) => x > t) - 1));
  const s = (t - times[k]) / (times[k + 1] - times[k]);
  const at = (i: number): number => poses[7 * k + i] + s * (poses[7 * k + 7 + i] - poses[7 * k + i]);
  return [at(0), at(1), at(2)];
}

const [left, still, right] = ['Left', 'Still', 'Right'].map(seen);

/** A surface lit by a chart's own lamp, at rest relative to it. */
const light = lampOf('Left').spectrum!;
const color = (name: string, D: number): Vec3 => observedColor(bands(material(name)), WHITE_FILTER, light, 1, D);
const red = ([r, g, b]: Vec3): boolean => r > 1.5 * g && r > 1.5 * b;
const blue = ([r, g, b]: Vec3): boolean => b > 1.5 * r && b > 1.2 * g;

describe('prism', () => {
  it('opens with one chart approaching at 0.34 c, one at rest, and one receding', () => {
    for (const name of ['Left', 'Right'])
      expect(fastestVertex(objectAt(scene, `/World/${name}`), c).speed / c).toBeCloseTo(0.34, 2);
    expect(left.beta).toBeGreaterThan(0.29);
    expect(still).toEqual({ beta: 0, D: 1 });
    expect(right.beta).toBeLessThan(-0.29);
  });

  it('has a lamp of the same light moving with each chart', () => {
    for (const name of ['Left', 'Still', 'Right']) {
      const chart = objectAt(scene, `/World/${name}`).motion;
      if (chart.kind === 'sampled-points') throw new Error('charts are rigid');
      const offset = (t: number) => sub(place(lampOf(name).motion, t), place(chart, t));
      for (const t of [0, 4, 9, 20]) expect(length(sub(offset(t), offset(1)))).toBeLessThan(1e-6);
      expect(lampOf(name).spectrum).toEqual(light);
    }
  });

  it('shows red and orange fields blue when approaching', () => {
    for (const field of ['field22', 'field10']) {
      expect(red(color(field, 1)), field).toBe(true);
      expect(blue(color(field, left.D)), field).toBe(true);
    }
  });

  it('shows the blue field red and the red one dark teal when receding', () => {
    expect(blue(color('field20', 1))).toBe(true);
    expect(red(color('field20', right.D))).toBe(true);
    const [r, g, b] = color('field22', right.D);
    expect(Math.min(g, b)).toBeGreaterThan(2 * r);
    expect(Math.max(g, b)).toBeLessThan(0.3 * color('field22', 1)[0]);
  });

  // D⁴ of beaming, times the change of the visible part by the shift.
  it('is brighter approaching and darker receding', () => {
    const white = (D: number) => D ** 4 * dot(LUMINANCE_WEIGHTS, color('field30', D));
    expect(white(left.D) / white(1)).toBeGreaterThan(2);
    expect(white(right.D) / white(1)).toBeLessThan(0.5);
  });

  it('shows the green leaf red when approaching, by its infrared reflectance', () => {
    const leaf = material('leaf');
    const [r, g] = color('leaf', 1);
    expect(g).toBeGreaterThan(r);
    expect(red(color('leaf', left.D))).toBe(true);
    expect(red(observedColor(filterFromRgb(leaf.baseColor), WHITE_FILTER, light, 1, left.D))).toBe(false);
  });
});
