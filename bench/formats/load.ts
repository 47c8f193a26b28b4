import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import type { Bench } from '../support/bench.ts';
import { dancerGlb } from './dancer.ts';
import { type Case, python, readersTable } from './readers.ts';

const cases: readonly Case[] = [
  { what: '60 skinned meshes, 34,560 vertices, 1,300 poses', file: 'dancer.glb' },
  {
    what: 'the same',
    file: 'dancer.usdc',
    not: { three: 'draws the skeleton, and bakes nothing' },
  },
  {
    what: '1,000 instances of a cage of 961 faces, each with a scale of its own',
    file: 'pots.usdc',
    not: { usdCore: 'reads the cage, and refines nothing', three: 'reads the cage, and refines nothing' },
  },
  { what: '10,000 instances of 968 triangles', file: 'alike.usdc', not: { three: 'knows no PointInstancer' } },
  { what: 'the same, each with a scale of its own', file: 'own.usdc', not: { three: 'knows no PointInstancer' } },
];

export const load: Bench = {
  name: 'load',
  title: 'Opening scenes like those of other people',
  about:
    'As above, for files made like some that are too large to be kept here: a character like BrainStem of the Khronos samples, teapots and crowds like those of the USD working group. usd-core gives the points of a skin at all poses; ours and three.js keep joints and weights. ' +
    '`npm run bench -- load FILE…` opens files of your own in their place.',
  async run(files) {
    if (files.length > 0)
      return [
        readersTable(
          '',
          files.map((file) => ({ what: 'from elsewhere', file: resolve(file) })),
          python('check') !== undefined,
        ),
      ];
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      writeFileSync(join(folder, 'dancer.glb'), await dancerGlb());
      const written = python('load', folder) !== undefined;
      if (!written) console.error('  usd-core is not in .cache/venv (npm test -- oracle puts it there): no crates');
      return [readersTable(folder, cases, written)];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};
