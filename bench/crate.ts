import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Bench, median, type Table } from './bench.ts';
import { inChild } from './inChild.ts';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const script = join(root, 'bench', 'crate.py');
const ROUNDS = 5;

interface Theirs {
  readonly opened: number;
  readonly asked: number;
}

export const crate: Bench = {
  name: 'crate',
  title: 'Reading a binary USD layer',
  about:
    "From bytes in memory to every value in its layer, in a fresh process each time and so not yet compiled; then again in the same process. Pixar's usd-core reads the same file in turn, also in a fresh process: it maps the file and reads a value when it is asked for, which its last column does for all, through Python.",
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      if (python('write', folder) === undefined) {
        console.error('  usd-core is not in .cache/venv (npm test -- oracle puts it there): no crates to read');
        return [];
      }
      return [table(['points', 'prims'].map((name) => join(folder, `${name}.usdc`)))];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

function table(files: readonly string[]): Table {
  const rows = files.map((file) => {
    const rounds = Array.from({ length: ROUNDS }, () => ({
      ours: inChild<{ first: number; again: number }>('crate', file),
      theirs: JSON.parse(python('read', file) ?? '{}') as Theirs,
    }));
    const times = [
      rounds.map((r) => r.ours.first),
      rounds.map((r) => r.ours.again),
      rounds.map((r) => r.theirs.opened),
      rounds.map((r) => r.theirs.asked),
    ].map((seconds) => 1000 * median(seconds));
    return [file.includes('points') ? 'meshes' : '60,000 prims', statSync(file).size / 1e6, ...times];
  });
  return {
    columns: ['of', 'size [MB]', 'first [ms]', 'again [ms]', 'usd-core opens [ms]', '… and tells all [ms]'],
    rows,
  };
}

/** What the script prints; undefined where it cannot run. */
function python(...args: string[]): string | undefined {
  const own = join(root, '.cache', 'venv', 'bin', 'python3');
  const done = spawnSync(existsSync(own) ? own : 'python3', [script, ...args], { encoding: 'utf8' });
  return done.status === 0 ? done.stdout : undefined;
}
