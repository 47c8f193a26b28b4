import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Bench } from '../support/bench.ts';
import { writeFiles } from './formatFiles.ts';
import { type Case, python, readersTable } from './readers.ts';

const STATIC = '1,000,000 triangles';
const CROWD = '1,000 × 10,000 triangles';
const NO_INSTANCER = 'knows no PointInstancer';
const NO_BAKE = 'draws the skeleton, and bakes nothing';
const NO_REFINE = 'reads the cage, and refines nothing';
const ONE_SHAPE = 'shows one sample of the points';
const files: readonly Case[] = [
  ...['.usda', '.usdc', '.usdz', '.glb'].map((end) => ({ what: STATIC, file: `million${end}` })),
  { what: STATIC, file: 'million.draco.glb', not: { three: 'decodes Draco only in a browser' } },
  ...['.meshopt.glb', '.obj', '.ply', '.text.ply', '.stl'].map((end) => ({ what: STATIC, file: `million${end}` })),
  { what: '100,000 vertices × 250 samples, in memory', file: 'moving.usdc', inMemory: true, not: { three: ONE_SHAPE } },
  {
    what: '100,000 vertices × 250 samples, left in the file',
    file: 'moving.usdc',
    not: { usdCore: 'is asked for all of them', three: ONE_SHAPE },
  },
  { what: CROWD, file: 'instancer.usdc', not: { three: NO_INSTANCER } },
  ...['instanceable.usdc', 'instances.glb'].map((file) => ({ what: CROWD, file })),
  { what: '10 MB of arrays', file: 'arrays.usdc', not: { three: ONE_SHAPE } },
  { what: '60,000 prims', file: 'prims.usdc' },
  { what: '100,000 vertices × 100 samples, skinned', file: 'skinned.usdc', not: { three: NO_BAKE } },
  {
    what: '100,000 faces, subdivided once',
    file: 'subdivision.usdc',
    not: { usdCore: NO_REFINE, three: NO_REFINE },
  },
];

/** Subdivision surfaces get one level. */
const cases = files.map((one) => ({ subdivision: 1, ...one }));

export const formats: Bench = {
  name: 'formats',
  title: 'Opening files',
  about:
    'From a file on disk to a scene in memory, each time in a fresh process, whose code has not been compiled yet; the readers take turns. *Memory*: the most that is resident, beyond the process before it reads. ' +
    "*usd-core*: Pixar's own library opens the stage and gives, through Python, the values of which our scene is made as arrays: points and normals at all times, faces, uvs, world matrices, instances, baked skins. It maps a crate and copies arrays as they are; ours also cuts polygons into triangles, joins their corners to vertices, makes normals, and follows a skin between its samples with as many more as its curved ways take. " +
    '*three.js*: its loader for that kind of file; ours decodes Draco and meshopt without WebAssembly, which the security policy of the page forbids. Modules are loaded before the time begins. –: it has no reader for the file, or a note below says why.',
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      await writeFiles(folder);
      const hasUsdCore = python('write', folder) !== undefined;
      if (!hasUsdCore) console.error('  usd-core is not in .cache/venv (npm test -- oracle puts it there): no crates');
      return [readersTable(folder, cases, hasUsdCore)];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};
