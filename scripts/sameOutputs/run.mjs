// Runs the jobs of `npm run sameOutputs`, a few to a process, and keeps digests of what they wrote.
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { say } from '../setup.mjs';

const PROCESSES = 2;
const BATCH = fileURLToPath(new URL('batch.mjs', import.meta.url));
/** A process is given jobs up to this weight. */
const HEAVIEST_BATCH = 16;
/** Where outputs and temporary worktrees are. */
export const home = join(tmpdir(), 'slowlight-same-outputs');
/** Called when the process ends, however it does. */
export const cleanups = [];

for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(130));
process.on('exit', () => {
  for (const cleanup of cleanups) cleanup();
});

/** Runs jobs in `PROCESSES` processes at once, the heaviest batches first. */
export async function runJobs(name, tree, jobs, place, done) {
  const batches = [...batchesOf(jobs)].sort((a, b) => weightOf(b) - weightOf(a));
  const began = performance.now();
  const elapsed = () => Math.round((performance.now() - began) / 1000);
  let finished = 0;
  const work = async () => {
    for (let batch = batches.shift(); batch; batch = batches.shift()) {
      await runBatch(tree, batch, place);
      for (const job of batch) {
        keepResult(place(job));
        done(job);
      }
      finished += batch.length;
      say(`${name}: ${finished}/${jobs.length} jobs, ${elapsed()} s: ${batch[0].batch}`);
    }
  };
  await Promise.all(Array.from({ length: PROCESSES }, work));
}

/** Jobs of one process each; heavy batches are split, so that both processes have work until the end. */
function batchesOf(jobs) {
  const open = new Map();
  const full = [];
  for (const job of jobs) {
    const batch = [...(open.get(job.batch) ?? []), job];
    if (weightOf(batch) < HEAVIEST_BATCH) open.set(job.batch, batch);
    else {
      full.push(batch);
      open.delete(job.batch);
    }
  }
  return [...full, ...open.values()];
}

const weightOf = (batch) => batch.reduce((sum, { weight }) => sum + weight, 0);

/** A job that ends the process leaves no exits.json: its exit code is that of the process, and the next process goes on with the job after it. */
async function runBatch(tree, batch, place) {
  const list = join(temporaryFolder('list-'), 'jobs.json');
  for (let left = batch; left.length > 0; ) {
    writeFileSync(list, JSON.stringify(left.map((job) => ({ folder: place(job), steps: job.steps }))));
    const ended = await runProcess([BATCH, join(tree, 'bin/slowlight.js'), list]);
    const at = left.findIndex((job) => !existsSync(join(place(job), 'exits.json')));
    if (at < 0) return;
    makeFolder(place(left[at]));
    writeFileSync(join(place(left[at]), 'exits.json'), JSON.stringify({ exits: [ended], seconds: 0 }));
    left = left.slice(at + 1);
  }
}

/** The exit code or the signal. What a driver prints is left out; what the program prints, the process keeps itself. */
function runProcess(args) {
  const child = spawn(process.execPath, args, { stdio: 'ignore' });
  const stop = () => child.kill();
  cleanups.push(stop);
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (code, signal) => {
      cleanups.splice(cleanups.indexOf(stop), 1);
      resolve(code ?? signal);
    });
  });
}

export function temporaryFolder(prefix) {
  const folder = mkdtempSync(join(makeFolder(home), prefix));
  cleanups.push(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

export function makeFolder(folder) {
  mkdirSync(folder, { recursive: true });
  return folder;
}

/** Another run may have been quicker: what it made is the same. */
export function moveTo(place, folder) {
  try {
    renameSync(folder, place);
  } catch (error) {
    if (!existsSync(place)) throw error;
    rmSync(folder, { recursive: true });
  }
}

export const hash = (content) => createHash('sha256').update(content).digest('hex').slice(0, 32);

/**
 * Writes result.json: `data`, which must be the same, and `texts`, for people. JSON on standard output is data but for its messages; what else is printed is
 * text. The job's own folder is left out of what is printed.
 */
function keepResult(folder) {
  const { exits, seconds } = JSON.parse(readFileSync(join(folder, 'exits.json'), 'utf8'));
  const result = { seconds, data: { 'exit codes': exits.join(' ') }, texts: {} };
  for (const path of filesUnder(folder)) {
    const name = relative(folder, path).replaceAll('\\', '/');
    const bytes = readFileSync(path);
    if (name === 'exits.json' || name === 'result.json') continue;
    if (!/^\d+\.std(out|err)$/.test(name)) {
      result.data[name] = hash(bytes);
    } else if (bytes.length > 0) {
      const text = bytes.toString().replaceAll(folder, '.');
      writeFileSync(path, text);
      keepPrinted(result, name, text);
    }
  }
  writeResult(folder, result);
}

function keepPrinted({ data, texts }, name, text) {
  texts[name] = hash(text);
  if (!/^[{[]/.test(text)) return;
  try {
    data[name] = hash(JSON.stringify(JSON.parse(text, (key, value) => (key === 'message' ? undefined : value))));
  } catch {
    // Not JSON after all.
  }
}

export const resultIn = (folder) => JSON.parse(readFileSync(join(folder, 'result.json'), 'utf8'));

export const writeResult = (folder, result) => writeFileSync(join(folder, 'result.json'), JSON.stringify(result));

export const differing = (a, b) =>
  [...new Set([...Object.keys(a), ...Object.keys(b)])].filter((name) => a[name] !== b[name]);

function filesUnder(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesUnder(path) : [path];
  });
}
