import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Bench } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';

const root = fileURLToPath(new URL('../../../../', import.meta.url));
const script = join(root, 'src', 'formats', 'usd', 'fixtures', 'caches.py');
/** Points along one side of the cloth; 99,856 in total. */
const SIDE = 316;
/** Frames of 300 MB, which also fit into memory, and of 2.1 GB. */
const [SHORT, LONG] = [250, 1750];

/** Arguments of child.ts: where the samples are kept, and the number of pictures. */
export interface CacheTask {
  readonly file: string;
  readonly inMemory: boolean;
}
export interface CachePlayback {
  readonly load: number;
  readonly loadedBytes: number;
  readonly first: number;
  readonly frame: number;
  readonly peakBytes: number;
}

export const cache: Bench = {
  name: 'cache',
  title: 'Playing a long point cache',
  about:
    'A cloth of 99,856 points in a crate by usd-core, left in its file and, where there is room, in memory (24 bytes per vertex and sample): from the file to a scene, then pictures of 480 × 270 at one sample of time after another, each of which needs a new sample; ' +
    'in a process of its own. The peak is of the whole process, with a software GPU that is the memory of the GPU as well.',
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      const rows = [SHORT, LONG].flatMap((frames) => {
        const file = join(folder, `${frames}.usdc`);
        if (!write(file, frames)) return [];
        const kinds = frames === SHORT ? [true, false] : [false];
        return kinds.map((inMemory) => row(file, frames, inMemory));
      });
      if (rows.length === 0)
        console.error('  usd-core is not in .cache/venv (npm test -- oracle puts it there): no cache');
      const columns = ['samples', 'file [MB]', 'kept', 'load [s]', 'then resident [MiB]', 'first picture [ms]'];
      return rows.length === 0 ? [] : [{ columns: [...columns, 'picture [ms]', 'peak [MiB]'], rows }];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

function row(file: string, frames: number, inMemory: boolean): (string | number)[] {
  const task: CacheTask = { file, inMemory };
  const { load, loadedBytes, first, frame, peakBytes } = inChild<CachePlayback>('cache', JSON.stringify(task));
  const kept = inMemory ? 'in memory' : 'in its file';
  const size = statSync(file).size / 1e6;
  return [
    frames.toLocaleString('en'),
    size,
    kept,
    load / 1000,
    loadedBytes / 2 ** 20,
    first,
    frame,
    peakBytes / 2 ** 20,
  ];
}

/** Writes the file; false if that fails. */
function write(file: string, frames: number): boolean {
  const own = join(root, '.cache', 'venv', 'bin', 'python3');
  const python = existsSync(own) ? own : 'python3';
  return spawnSync(python, [script, 'long', file, String(SIDE), String(frames)]).status === 0;
}
