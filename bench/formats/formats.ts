import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Bench, figure, median, type Table } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';
import { writeFiles } from './formatFiles.ts';

const root = fileURLToPath(new URL('../../../../', import.meta.url));
const script = join(root, 'bench', 'formats', 'formats.py');
const ROUNDS = 3;

/** Argument of child.ts: whether all samples are read into memory. */
export interface LoadTask {
  readonly file: string;
  readonly inMemory: boolean;
}

/** A reader's time and memory for a file, or why it fails. */
type LoadMeasurement = { readonly seconds: number; readonly bytes: number } | { readonly refusal: string };

interface Case {
  readonly what: string;
  readonly file: string;
  /** Reads all samples into memory; otherwise large ones stay in the file. */
  readonly inMemory?: boolean;
  /** Why a reader is excluded: it would not do the same work. */
  readonly not?: { readonly usdCore?: string; readonly three?: string };
}

const STATIC = '1,000,000 triangles';
const CROWD = '1,000 × 10,000 triangles';
const NO_BAKE = 'draws the skeleton, and bakes nothing';
const NO_REFINE = 'reads the cage, and refines nothing';
const ONE_SHAPE = 'shows one sample of the points';
const cases: readonly Case[] = [
  ...['.usda', '.usdc', '.usdz', '.glb'].map((end) => ({ what: STATIC, file: `million${end}` })),
  { what: STATIC, file: 'million.draco.glb', not: { three: 'decodes Draco only in a browser' } },
  ...['.meshopt.glb', '.obj', '.ply', '.text.ply', '.stl'].map((end) => ({ what: STATIC, file: `million${end}` })),
  { what: '100,000 vertices × 250 samples, in memory', file: 'moving.usdc', inMemory: true, not: { three: ONE_SHAPE } },
  {
    what: '100,000 vertices × 250 samples, left in the file',
    file: 'moving.usdc',
    not: { usdCore: 'is asked for all of them', three: ONE_SHAPE },
  },
  ...['instancer.usdc', 'instanceable.usdc', 'instances.glb'].map((file) => ({ what: CROWD, file })),
  { what: '10 MB of arrays', file: 'arrays.usdc', not: { three: ONE_SHAPE } },
  { what: '60,000 prims', file: 'prims.usdc' },
  { what: '100,000 vertices × 100 samples, skinned', file: 'skinned.usdc', not: { three: NO_BAKE } },
  {
    what: '100,000 faces, subdivided once',
    file: 'subdivision.usdc',
    not: { usdCore: NO_REFINE, three: NO_REFINE },
  },
];

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
      return [table(folder, hasUsdCore)];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

const READERS = ['Slowlight', 'usd-core', 'three.js'] as const;

function table(folder: string, hasUsdCore: boolean): Table {
  const notes = new Set<string>();
  const rows = cases.flatMap((one) => {
    const path = join(folder, one.file);
    if (!existsSync(path)) return [];
    console.error(`  ${one.file}`);
    const asked = readers(one, path, hasUsdCore);
    const taken = rounds(asked);
    for (const [i, each] of taken.entries()) {
      if (each && 'refusal' in each) notes.add(`${one.file}: ${READERS[i]} ${each.refusal}.`);
    }
    return [[one.what, one.file, statSync(path).size / 1e6, ...taken.flatMap(cells)]];
  });
  const columns = READERS.flatMap((reader) => [`${reader} [s]`, '[MiB]']);
  return { columns: ['', 'file', 'size [MB]', ...columns], rows, remark: [...notes].join(' ') };
}

type Reader = () => LoadMeasurement;

/** Results of the three readers in column order; undefined if a reader does not support the file. */
function readers({ file, inMemory, not }: Case, path: string, hasUsdCore: boolean): readonly (Reader | undefined)[] {
  const refused =
    (refusal: string): Reader =>
    () => ({ refusal });
  const usdCore = (): LoadMeasurement =>
    JSON.parse(python('read', path) ?? '{ "refusal": "fails" }') as LoadMeasurement;
  const isUsd = /\.usd[acz]$/.test(file);
  return [
    () =>
      inChild<LoadMeasurement>('load', JSON.stringify({ file: path, inMemory: inMemory === true } satisfies LoadTask)),
    isUsd && hasUsdCore ? (not?.usdCore ? refused(not.usdCore) : usdCore) : undefined,
    not?.three ? refused(not.three) : () => inChild<LoadMeasurement>('three', path),
  ];
}

/** Medians over rounds in which the readers alternate. */
function rounds(asked: readonly (Reader | undefined)[]): readonly (LoadMeasurement | undefined)[] {
  const all = Array.from({ length: ROUNDS }, () => asked.map((read) => read?.()));
  return asked.map((_, i) => {
    const each = all.map((round) => round[i]).filter((taken) => taken !== undefined);
    const read = each.filter((taken) => 'seconds' in taken);
    if (read.length < ROUNDS) return each.find((taken) => 'refusal' in taken);
    return { seconds: median(read.map((t) => t.seconds)), bytes: median(read.map((t) => t.bytes)) };
  });
}

const cells = (taken: LoadMeasurement | undefined): readonly string[] =>
  taken && 'seconds' in taken ? [figure(taken.seconds), figure(taken.bytes / 2 ** 20)] : ['–', '–'];

/** Output of the Python script; undefined if it cannot run. */
function python(...args: string[]): string | undefined {
  const own = join(root, '.cache', 'venv', 'bin', 'python3');
  const done = spawnSync(existsSync(own) ? own : 'python3', [script, ...args], { encoding: 'utf8' });
  return done.status === 0 ? done.stdout : undefined;
}
