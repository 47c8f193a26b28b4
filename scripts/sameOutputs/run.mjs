// Runs the jobs of `npm run sameOutputs`, several per process, and stores digests of their outputs.
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
/** Maximum total weight of the jobs of a process. */
const HEAVIEST_BATCH = 16;
/** Folder of outputs and temporary worktrees. */
export const home = join(tmpdir(), 'slowlight-same-outputs');
/** Called when the process ends in any way. */
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

/** Splits batches into the jobs of one process each, so that both processes are busy until the end. */
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

/** A job that terminates the process leaves no exits.json: it gets the process's exit code, and a new process continues with the next job. */
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

/** Resolves to the exit code or signal. Output of drivers is dropped; the process records the program's output itself. */
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

/** Another run may have created it meanwhile, with the same content. */
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
 * Writes result.json: `data`, which must be equal, and `texts`, which are reported. JSON on standard output is data except for its messages; other output is
 * text. The job's own folder is removed from the output.
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
    // Not JSON.
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
