import { spawnSync } from 'node:child_process';
import { existsSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { figure, median, type Table } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';

const root = fileURLToPath(new URL('../../../../', import.meta.url));
const script = join(root, 'bench', 'formats', 'formats.py');
const ROUNDS = 3;

/** Argument of child.ts: whether all samples are read into memory, and the levels of subdivision surfaces; absent: as they look smooth. */
export interface LoadTask {
  readonly file: string;
  readonly inMemory: boolean;
  readonly subdivision?: number;
}

/** A reader's time and memory for a file, or why it fails. */
type LoadMeasurement = { readonly seconds: number; readonly bytes: number } | { readonly refusal: string };

/** A file that the readers open. */
export interface Case {
  readonly what: string;
  readonly file: string;
  /** Reads all samples into memory; otherwise large ones stay in the file. */
  readonly inMemory?: boolean;
  readonly subdivision?: number;
  /** Why a reader is excluded: it would not do the same work. */
  readonly not?: { readonly usdCore?: string; readonly three?: string };
}

const READERS = ['Slowlight', 'usd-core', 'three.js'] as const;

/** Time and memory of the readers for files in a folder; those that are not there are left out. */
export function readersTable(folder: string, cases: readonly Case[], hasUsdCore: boolean): Table {
  const notes = new Set<string>();
  const rows = cases.flatMap((one) => {
    const path = resolve(folder, one.file);
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
function readers(
  { file, inMemory, subdivision, not }: Case,
  path: string,
  hasUsdCore: boolean,
): readonly (Reader | undefined)[] {
  const refused =
    (refusal: string): Reader =>
    () => ({ refusal });
  const usdCore = (): LoadMeasurement =>
    JSON.parse(python('read', path) ?? '{ "refusal": "fails" }') as LoadMeasurement;
  const task: LoadTask = { file: path, inMemory: inMemory === true, ...(subdivision !== undefined && { subdivision }) };
  const isUsd = /\.usd[acz]$/.test(file);
  return [
    () => inChild<LoadMeasurement>('load', JSON.stringify(task)),
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

/** Output of formats.py; undefined if it cannot run. */
export function python(...args: string[]): string | undefined {
  const own = join(root, '.cache', 'venv', 'bin', 'python3');
  const done = spawnSync(existsSync(own) ? own : 'python3', [script, ...args], { encoding: 'utf8' });
  return done.status === 0 ? done.stdout : undefined;
}
