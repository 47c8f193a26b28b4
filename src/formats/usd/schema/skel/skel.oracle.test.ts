import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { type BakedStage, expectBaked } from './fixtures/expectBaked.ts';

const fixture = (name: string): string => fileURLToPath(new URL(`./fixtures/${name}`, import.meta.url));
const oracle = (...args: string[]): never => JSON.parse(python(fixture('oracle.py'), ...args)) as never;
const man = fileURLToPath(
  new URL('../../../../../../shared/data/usd/test_assets/USDZ/CesiumMan/CesiumMan.usdz', import.meta.url),
);

describe.skipIf(!hasUsdCore())('usd-core', () => {
  it('reproduces the committed values', () => {
    const committed: BakedStage[] = JSON.parse(readFileSync(fixture('expected.json'), 'utf8'));
    expect(oracle('seed', ...committed.map(({ seed }) => `${seed}`))).toEqual(committed);
  });

  it('agrees on other random skeletons', async () => {
    const stages: BakedStage[] = oracle('seed', ...Array.from({ length: 30 }, (_, i) => `${101 + i}`));
    for (const stage of stages) await expectBaked(stage);
  });

  it.skipIf(!existsSync(man))('agrees on the points of CesiumMan, also between samples', async () => {
    const source = memorySource({ 'man.usdz': new Uint8Array(readFileSync(man)) });
    const { objects } = await readUsd(source, 'man.usdz', { chordTolerance: 1e-5 });
    const times = [0, 0.02, 0.5, 1.03, 1.9];
    const codes = times.map((t) => `${t * CODES}`);
    const baked: BakedStage['meshes'] = oracle('file', man, ...codes);
    for (const [path, samples] of Object.entries(baked)) {
      const object = objects.find((o) => o.path === path)!;
      // Vertices are points here, numbered by first occurrence in the order of the corners.
      const order = [...new Set(object.mesh.indices)];
      expect(order.length).toBe(samples[0].points.length / 3);
      for (const [i, { points }] of samples.entries()) {
        const known = new Set(placesOf(points));
        for (let v = 0; v < order.length; v += 13) {
          const p = vertexPosition(object, v, times[i], 3e8);
          const nearest = Math.min(...[...known].map((q) => Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2])));
          expect(nearest, `vertex ${v} at ${times[i]} s`).toBeLessThan(1e-4);
        }
      }
    }
  });
});

/** Time codes per second of that file. */
const CODES = 24;
const placesOf = (points: readonly number[]): number[][] =>
  Array.from({ length: points.length / 3 }, (_, i) => points.slice(3 * i, 3 * i + 3));
