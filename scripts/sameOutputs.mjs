// `npm run sameOutputs -- REF`: proves that a change of the code changes no output. Runs the program of the working tree and that of a git commit on all
// examples of that commit, and compares what they write to the bit: pictures (WebGPU, WebGL2, reference renderer) with their data channels, probes, converted
// files, simulations and exit codes. Ends with 1 where any of it differs. Differences of help, messages and refusals are reported, and are no failure.
//
//     npm run sameOutputs -- main
//     npm run sameOutputs -- 5993356 --only dice,street --kinds render,reference,probe,convert
//     npm run sameOutputs -- main --thorough
//
// `--thorough` renders every scene in every view, at rest and moving, with each pipeline, and every project with each: three times as long.
// Outputs of the commit are cached in the temporary folder of the system, so that later runs run the working tree only; `--fresh` ignores the cache.
// On software GPUs (SwiftShader, llvmpipe) pictures are reproducible except as described at ATTEMPTS; for hardware GPUs this is unknown: compare a commit with
// itself first.
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, lstatSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { jobsFor, KIND_GROUPS, KINDS, SCENE_FILE } from './sameOutputs/jobs.mjs';
import { report } from './sameOutputs/report.mjs';
import {
  cleanups,
  differing,
  hash,
  home,
  makeFolder,
  moveTo,
  resultIn,
  runJobs,
  temporaryFolder,
  writeResult,
} from './sameOutputs/run.mjs';
import { checkNode, ensureBuilt, ensureModules, ensureSystem, root, run, SetupError, say } from './setup.mjs';

/** Part of each cached job's key; increase it when the format of the cache changes. */
const CACHE_VERSION = 2;
/**
 * The tessellator appends triangles with atomic counters, so that their order, and with it the winner of equal depths, varies between runs: a few pixels
 * of few pictures. A picture that differs is rendered again up to ATTEMPTS times, unless more than MAX_AGAIN differ; one match is enough.
 */
const ATTEMPTS = 6;
const MAX_AGAIN = 12;

try {
  const { ref, ...options } = parseArguments(process.argv.slice(2));
  checkNode();
  ensureModules();
  if (ensureSystem('which the pictures need').length > 0)
    throw new SetupError('system packages are missing, see above.');
  const commit = git('rev-parse', '--verify', '--quiet', `${ref}^{commit}`).trim();
  const before = { name: `${ref} (${commit.slice(0, 7)})`, folder: join(home, commit) };
  const jobs = chosenJobs(inputsOf(commit, before.folder), options);
  await runBefore(commit, before, jobs, options.fresh);
  const now = await runNow(jobs);
  await runAgain(jobs, before, now);
  process.exitCode = report(jobs, before, now);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run sameOutputs: ${error.message}`);
  process.exitCode = 1;
}

// ── What to run ────────────────────────────────────────────────────────────────────────────────────────────────────

function parseArguments(words) {
  const options = { only: [], kinds: [], fresh: false, thorough: false };
  for (let i = 0; i < words.length; i++) {
    const list = () => (words[++i] ?? '').split(',').filter(Boolean);
    if (words[i] === '--only') options.only.push(...list());
    else if (words[i] === '--kinds') options.kinds.push(...list().flatMap((kind) => KIND_GROUPS[kind] ?? kind));
    else if (words[i] === '--fresh' || words[i] === '--thorough') options[words[i].slice(2)] = true;
    else if (options.ref === undefined && !words[i].startsWith('-')) options.ref = words[i];
    else throw new SetupError(`what is ${words[i]}? ${usage()}`);
  }
  if (options.ref === undefined) throw new SetupError(`name a git commit to compare with. ${usage()}`);
  const unknown = options.kinds.filter((kind) => !KINDS.includes(kind));
  if (unknown.length > 0) throw new SetupError(`no kind ${unknown.join(', ')}. ${usage()}`);
  return options;
}

function usage() {
  const kinds = [...Object.keys(KIND_GROUPS), ...KINDS].join(', ');
  return `npm run sameOutputs -- REF [--only NAME,…] [--kinds KIND,…] [--thorough] [--fresh]; kinds: ${kinds}`;
}

function git(...args) {
  const done = spawnSync('git', args, { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 28 });
  if (done.status !== 0) throw new SetupError(`git ${args.join(' ')} failed. ${done.stderr}`.trim());
  return done.stdout;
}

/** The commit's examples, and the scene files of its tests with their folders; inputs of both programs. */
function inputsOf(commit, folder) {
  const all = git('ls-tree', '-r', '--name-only', '-z', commit).split('\0').filter(Boolean);
  const folders = new Set(all.filter((path) => SCENE_FILE.test(path)).map((path) => dirname(path)));
  const paths = all.filter((path) => path.startsWith('examples/') || folders.has(dirname(path)));
  const inputs = join(folder, 'inputs');
  if (!existsSync(inputs)) {
    const unpacked = mkdtempSync(join(makeFolder(folder), 'unpacked-'));
    const archive = join(unpacked, 'inputs.tar');
    git('archive', '--format=tar', '-o', archive, commit, '--', ...paths);
    execFileSync('tar', ['-xf', archive], { cwd: unpacked });
    rmSync(archive);
    moveTo(inputs, unpacked);
  }
  return { folder: inputs, paths };
}

function chosenJobs({ folder, paths }, { only, kinds, thorough }) {
  const jobs = jobsFor(folder, paths);
  const subjects = new Set(jobs.map(({ subject }) => subject));
  const unknown = only.filter((name) => !subjects.has(name));
  if (unknown.length > 0)
    throw new SetupError(`no example ${unknown.join(', ')}; there are ${[...subjects].join(', ')}.`);
  const chosen = jobs.filter(
    (job) =>
      (thorough || !job.thorough) &&
      (only.length === 0 || only.includes(job.subject)) &&
      (kinds.length === 0 || kinds.includes(job.kind)),
  );
  if (chosen.length === 0) throw new SetupError('there is nothing of these kinds to run.');
  const environment = environmentKey();
  return chosen.map((each) => ({ ...each, key: hash(JSON.stringify([CACHE_VERSION, environment, each.steps])) }));
}

/** Other dependencies of the outputs: the software GPUs come with Chromium and the system. */
function environmentKey() {
  const version = (program, flag) => spawnSync(program, [flag], { encoding: 'utf8' }).stdout ?? '';
  const { CHROMIUM = 'chromium', VK_ICD_FILENAMES, VK_DRIVER_FILES } = process.env;
  return [process.version, process.arch, version(CHROMIUM, '--version'), VK_ICD_FILENAMES, VK_DRIVER_FILES];
}

// ── Running ────────────────────────────────────────────────────────────────────────────────────────────────────────

/** Runs the jobs that are not cached with a build of the commit in a temporary worktree. */
async function runBefore(commit, before, jobs, fresh) {
  const place = (job) => join(before.folder, job.key);
  before.place = place;
  if (fresh) for (const job of jobs) rmSync(place(job), { recursive: true, force: true });
  const missing = jobs.filter((job) => !existsSync(place(job)));
  say(`${before.name}: ${jobs.length - missing.length} of ${jobs.length} jobs are cached in ${before.folder}`);
  if (missing.length === 0) return;
  const tree = buildOf(commit);
  const folder = temporaryFolder('before-');
  const unfinished = (job) => join(folder, job.key);
  await runJobs(before.name, tree, missing, unfinished, (job) => moveTo(place(job), unfinished(job)));
}

/** A worktree of the commit, built; removed at the end. */
function buildOf(commit) {
  const tree = join(temporaryFolder('tree-'), 'slowlight');
  git('worktree', 'add', '--detach', '--force', tree, commit);
  cleanups.unshift(() => {
    const modules = join(tree, 'node_modules');
    if (existsSync(modules) && lstatSync(modules).isSymbolicLink()) rmSync(modules);
    spawnSync('git', ['worktree', 'remove', '--force', tree], { cwd: root });
  });
  const lock = 'package-lock.json';
  // Otherwise the build below installs the commit's own.
  if (readFileSync(join(root, lock)).equals(readFileSync(join(tree, lock))))
    symlinkSync(join(root, 'node_modules'), join(tree, 'node_modules'), 'junction');
  run(process.execPath, [join(tree, 'scripts/build.mjs'), 'lib', 'app'], { cwd: tree });
  return tree;
}

async function runNow(jobs) {
  ensureBuilt('lib', 'app');
  const folder = mkdtempSync(join(home, 'now-'));
  const now = { name: 'working tree', folder, place: (job) => join(folder, job.id.replaceAll(/[^\w./-]+/g, '-')) };
  await runJobs(now.name, root, jobs, now.place, () => {});
  return now;
}

async function runAgain(jobs, before, now) {
  for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
    const results = (job) => [before, now].map(({ place }) => resultIn(place(job)));
    const unequal = jobs.filter((job) => {
      const [a, b] = results(job);
      return job.kind === 'webgpu' && differing(a.data, b.data).length > 0;
    });
    if (unequal.length === 0 || unequal.length > MAX_AGAIN) return;
    const folder = temporaryFolder('again-');
    const place = (job) => join(folder, job.key);
    await runJobs(`${now.name}, again`, root, unequal, place, (job) => {
      const [a, b] = results(job);
      const { data } = resultIn(place(job));
      const same = differing(a.data, b.data).filter((name) => data[name] === a.data[name]);
      for (const name of same) b.data[name] = data[name];
      writeResult(now.place(job), b);
      if (same.length > 0) say(`${job.id}: ${same.join(', ')} is the same when it is drawn again`);
    });
  }
}
