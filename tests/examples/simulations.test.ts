import { describe, expect, it } from 'vitest';
import { projects } from '../../examples/projects/index.ts';
import { orbit } from '../../examples/sets/planetarium.ts';
import { readFont } from '../../src/cli/files/fonts.ts';
import { COULOMB_CONSTANT } from '../../src/dynamics/forces/coulomb.ts';
import type { RunRecord } from '../../src/dynamics/runRecord.ts';
import { openScene } from '../../src/formats/open.ts';
import { Evaluator } from '../../src/graph/evaluation/evaluator.ts';
import { length, sub, type Vec3 } from '../../src/math/vec3.ts';
import { nodeLibrary } from '../../src/nodes/library.ts';
import { type LoadedScene, workerServices } from '../../src/nodes/services.ts';
import { poseAt, vertexPositions } from '../../src/scene/motion/motion.ts';
import type { SampledPointsMotion, Scene, SceneObject } from '../../src/scene/types.ts';
import { validate } from '../../src/scene/validation/validate.ts';
import { files } from './open.ts';

/** Speed of light [m/s] */
const C = 10;

const readScene = async (source: string): Promise<LoadedScene> => ({ scene: await openScene(files, source) });

/** Results of an example's simulations, by node; expects no warnings. */
async function run(name: string): Promise<(node: string) => { readonly scene: Scene; readonly books: RunRecord }> {
  const document = projects[name]!();
  const nodes = Object.entries(document.nodes).flatMap(([id, { type }]) => (type === 'simulate' ? [id] : []));
  const services = { ...workerServices, readFont, readScene };
  const { results } = await new Evaluator(nodeLibrary).evaluate(document, nodes, services);
  return (node) => {
    const result = results.get(node);
    if (result?.status !== 'done') throw new Error(JSON.stringify(result));
    const { scene } = result.outputs.geometry as LoadedScene;
    expect(scene.diagnostics).toEqual([]);
    expect(validate(scene, scene.hints.speedOfLight!)).toEqual([]);
    return { scene, books: result.outputs.books as RunRecord };
  };
}

const thing = (scene: Scene, path: string): SceneObject => scene.objects.find((object) => object.path === path)!;
const placeOf = (scene: Scene, path: string, t: number): Vec3 => poseAt(thing(scene, path).motion, t, C).position;
const most = (values: Iterable<number>): number => Array.from(values).reduce((a, b) => Math.max(a, b), -Infinity);
const least = (values: Iterable<number>): number => -most(Array.from(values, (value) => -value));
const framesOf = (scene: Scene, path: string) => {
  const { points, origin, times } = thing(scene, path).motion as SampledPointsMotion;
  return (points as Float32Array[]).map((at, k) => ({ t: times[k]!, at, origin }));
};
/** The greatest increase of a quantity between frames, relative to its range. */
const rises = (values: Float64Array): number =>
  most(values.slice(1).map((value, k) => value - values[k]!)) / (most(values) - least(values));

describe('hanging cloth', () => {
  it('hangs from two corners, approaches c without reaching it, and only loses energy', async () => {
    const { scene, books } = (await run('hanging-cloth'))('swing');
    const [start, end] = [0, 6].map((t) => vertexPositions(thing(scene, '/Cloth'), t, C));
    const held = Array.from({ length: 625 }, (_, v) => v).filter((v) =>
      [0, 1, 2].every((k) => start![3 * v + k] === end![3 * v + k]),
    );
    expect(held.map((v) => [...start!.subarray(3 * v, 3 * v + 3)].map((x) => Math.round(10 * x) / 10)).sort()).toEqual([
      [-1, 2.6, -1],
      [1, 2.6, -1],
    ]);
    expect(most(books.fastest) / C).toBeCloseTo(0.86, 1);
    expect(rises(books.total)).toBeLessThan(1e-3);
  });
});

describe('cloth on a ball', () => {
  it('stays out of ball and floor, and only loses energy', async () => {
    const { scene, books } = (await run('falling-cloth'))('fall');
    const frames = framesOf(scene, '/Cloth');
    let [near, low] = [Infinity, Infinity];
    for (const { at, origin } of frames)
      for (let i = 0; i < at.length; i += 3) {
        const p: Vec3 = [at[i]! + origin[0], at[i + 1]! + origin[1], at[i + 2]! + origin[2]];
        near = Math.min(near, length(sub(p, [0, 0.9, 0])));
        low = Math.min(low, p[1]);
      }
    expect(near).toBeGreaterThan(0.6);
    expect(low).toBeGreaterThan(0);
    expect(rises(books.total)).toBeLessThan(1e-3);
  });
});

describe('elastic ball against rigid ball', () => {
  it('conserves momentum and energy; the rigid ball leaves more slowly than the other came', async () => {
    const { scene, books } = (await run('impact'))('meeting');
    for (let i = 0; i < books.momentum.length; i++) expect(books.momentum[i]).toBeCloseTo(books.momentum[i % 3]!, 9);
    const swing = (most(books.total) - least(books.total)) / most(books.kinetic);
    const speed = (placeOf(scene, '/Rigid', 1.6)[0] - placeOf(scene, '/Rigid', 1.5)[0]) / 0.1;
    expect(swing).toBeLessThan(1e-3);
    expect(speed / C).toBeCloseTo(0.57, 2);
  });
});

describe('bouncing lattice', () => {
  it('is stopped at the bottom before the top, and bounces back', async () => {
    const { scene, books } = (await run('bouncing'))('fall');
    const frames = framesOf(scene, '/Lattice');
    const heights = frames.map(({ at, origin }) => least(at.filter((_, i) => i % 3 === 1)) + origin[1]);
    const tops = frames.map(({ at, origin }) => most(at.filter((_, i) => i % 3 === 1)) + origin[1]);
    const middles = frames.map(({ at, origin }) => {
      const ys = at.filter((_, i) => i % 3 === 1);
      return ys.reduce((a, b) => a + b, 0) / ys.length + origin[1];
    });
    const speed = (of: readonly number[], k: number): number => (of[k + 1]! - of[k]!) * 120;
    const stopped = heights.findIndex((_, k) => speed(heights, k) >= 0);
    // Then the top still falls faster than 0.05 s before; it is decelerated more than 0.04 s later.
    expect(speed(tops, stopped)).toBeLessThan(1.02 * speed(tops, stopped - 6));
    expect(speed(tops, stopped + 5)).toBeLessThan(0.97 * speed(tops, stopped));
    expect(speed(tops, stopped + 10)).toBeGreaterThan(0.9 * speed(tops, stopped));
    expect(most(heights.slice(stopped))).toBeGreaterThan(0.5);
    expect(least(heights)).toBeGreaterThan(-0.05);
    const lowest = middles.indexOf(least(middles.slice(0, stopped + 40)));
    expect(most(middles.slice(lowest))).toBeGreaterThan(middles[lowest]! + 0.8);
    expect(rises(books.total)).toBeLessThan(1e-3);
    expect(most(books.fastest)).toBeLessThan(C);
  });
});

describe('pendulums', () => {
  /** Period of a mass on a rod of 1 m released horizontally: by energy γ = 1 + g h/c², T = 4 ∫ dθ/v; θ = π/2 − w² removes the singularity at the start. */
  function period(c: number): number {
    const [g, n] = [9.8, 20_000];
    const top = Math.sqrt(Math.PI / 2);
    let sum = 0;
    for (let i = 0; i < n; i++) {
      const w = (top * (i + 0.5)) / n;
      const rise = (g * Math.sin(w * w)) / (c * c);
      sum += (2 * w) / ((c * Math.sqrt(rise * (2 + rise))) / (1 + rise));
    }
    return (4 * sum * top) / n;
  }

  it('swing with the period given by energy, at c = 1, 10 and 100', async () => {
    const of = await run('pendulums');
    for (const c of [1, 10, 100]) {
      const { scene, books } = of(`swing${c}`);
      const x = (t: number): number => placeOf(scene, `/Bob${c}`, t)[0];
      const times = Array.from({ length: 1399 }, (_, i) => i / 100);
      const turns = times.filter((t) => x(t) > 0 !== x(t + 0.01) > 0);
      expect(turns[2]! - turns[0]!).toBeCloseTo(period(c), 1);
      expect(most(books.fastest)).toBeLessThan(c);
    }
  });
});

describe("Newton's cradle", () => {
  it('transfers nearly all momentum and energy of the first ball to the last', async () => {
    const { scene } = (await run('cradle'))('swing');
    const paths = ['/First', '/Ball', '/Ball/copy2', '/Ball/copy3', '/Ball/copy4'];
    const speed = (path: string, t: number): number =>
      (placeOf(scene, path, t + 0.01)[0] - placeOf(scene, path, t - 0.01)[0]) / 0.02;
    const times = Array.from({ length: 280 }, (_, i) => 0.05 + i / 100);
    const first = most(times.map((t) => speed(paths[0]!, t)));
    const last = most(times.map((t) => speed(paths[4]!, t)));
    const hit = times.find((t) => speed(paths[4]!, t) > 0.95 * last)! + 0.05;
    expect(first / C).toBeCloseTo(0.47, 2);
    expect(last / first).toBeGreaterThan(0.97);
    for (const path of paths.slice(0, -1)) expect(Math.abs(speed(path, hit))).toBeLessThan(0.12 * first);
  });
});

describe('two charges', () => {
  it('have turning points given by energy and angular momentum, and follow a rosette', async () => {
    const { scene, books } = (await run('charges'))('dance');
    const orbitSamples = Array.from({ length: 721 }, (_, i) => {
      const t = i / 60;
      const [x, , z] = sub(placeOf(scene, '/Positive', t), placeOf(scene, '/Negative', t));
      return { r: Math.hypot(x, z), angle: Math.atan2(z, x) };
    });
    const [v, k] = [2.6, COULOMB_CONSTANT * 9.37e-5 ** 2];
    const gamma = 1 / Math.sqrt(1 - (v / C) ** 2);
    const L = 2 * 1.6 * gamma * v;
    const E = 2 * (gamma - 1) * C * C - k / 3.2;
    // At a turning point p = L/r: 2(√(p²c² + c⁴) − c²) − k/r = E. By bisection.
    const over = (r: number): number => 2 * (Math.sqrt((L * C) ** 2 / r ** 2 + C ** 4) - C * C) - k / r - E;
    let [a, b] = [0.01, 1.5];
    for (let i = 0; i < 100; i++) {
      const middle = (a + b) / 2;
      if (over(middle) > 0) a = middle;
      else b = middle;
    }
    // Maximum distance: interpolated between frames by a parabola through three.
    const turned = orbitSamples.flatMap(({ r, angle }, i) => {
      const [before, after] = [orbitSamples[i - 1], orbitSamples[i + 1]];
      if (!before || !after || r < before.r || r < after.r) return [];
      const part = (after.r - before.r) / (2 * r - before.r - after.r) / 2;
      const step = ((after.angle - before.angle + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
      return [angle + (part * step) / 2];
    });
    // An orbit of momentum p about a force centre of half the strength, since both move: Sommerfeld 1916.
    const turn = 2 * Math.PI * (1 / Math.sqrt(1 - (k / (2 * L * C)) ** 2) - 1);
    expect((turn * 180) / Math.PI).toBeCloseTo(45, 0);
    turned.forEach((angle, i) => {
      const off = angle + turn * (i + 1);
      expect(off - 2 * Math.PI * Math.round(off / (2 * Math.PI))).toBeCloseTo(0, 1);
    });
    expect(turned.length).toBeGreaterThan(3);
    // The same path is drawn on the table below, over all revolutions.
    const painted = orbit();
    let round = 0;
    orbitSamples.forEach(({ r, angle }, i) => {
      const step = angle - (orbitSamples[i - 1]?.angle ?? angle);
      round += step - 2 * Math.PI * Math.round(step / (2 * Math.PI));
      expect(2 * painted(round).away).toBeCloseTo(r, 2);
    });
    expect(most(books.fastest) / C).toBeCloseTo(0.6, 1);
    expect(least(orbitSamples.map(({ r }) => r)) / a).toBeCloseTo(1, 2);
    expect(most(orbitSamples.map(({ r }) => r))).toBeCloseTo(3.2, 3);
    expect((most(books.total) - least(books.total)) / most(books.kinetic)).toBeLessThan(1e-9);
  });
});
