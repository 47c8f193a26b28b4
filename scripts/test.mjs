// `npm test`: set-up, then every check and test, the fast ones first; goes on after a failed stage, and sums up at the end.
// `npm test -- unit cli` runs only some stages.
import { spawnSync } from 'node:child_process';
import { basename, delimiter, join } from 'node:path';
import { checkNode, ensureBuilt, ensureModules, ensureOracle, ensureSystem, root, SetupError } from './setup.mjs';

const tool = (path, ...args) => ({ path: join(root, 'node_modules', path), args });
const vitest = (project) => [tool('vitest/vitest.mjs', 'run', '--project', project)];

/** In order of execution. `needs`: `system` and `build` are required; without `python` a stage skips a part, with a message. */
const stages = {
  check: {
    steps: [
      tool('@biomejs/biome/bin/biome', 'check', '--error-on-warnings', '.'),
      tool('typescript/bin/tsc', '-p', 'tsconfig.json'),
      tool('typescript/bin/tsc', '-p', 'tsconfig.core.json'),
      tool('typescript/bin/tsc', '-p', 'bench/tsconfig.json', '--noEmit'),
      tool('typescript/bin/tsc', '-p', 'examples/tsconfig.json', '--noEmit'),
      tool('knip/bin/knip.js'),
      { path: join(root, 'scripts/build.mjs'), args: ['api'] },
    ],
  },
  unit: { steps: vitest('unit') },
  oracle: { steps: vitest('oracle'), needs: ['python'] },
  fuzz: { steps: vitest('fuzz'), needs: ['build'] },
  cli: { steps: vitest('cli'), needs: ['system', 'build'] },
  gpu: { steps: vitest('gpu'), needs: ['system'] },
  visual: { steps: vitest('visual'), needs: ['system'] },
  e2e: { steps: vitest('e2e'), needs: ['system', 'build'] },
};

const results = [];
let build;
try {
  checkNode();
  ensureModules();
  const chosen = choose(process.argv.slice(2));
  const need = new Set(chosen.flatMap((name) => stages[name].needs ?? []));
  if (need.has('system')) requireSystem();
  const judges = need.has('python') ? ensureOracle() : undefined;
  for (const name of chosen) runStage(name, judges);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm test: ${error.message}`);
  process.exitCode = 1;
}
summarize();

function choose(names) {
  const unknown = names.filter((name) => !(name in stages));
  if (unknown.length > 0) {
    throw new SetupError(`no stage ${unknown.join(', ')}; there are ${Object.keys(stages).join(', ')}.`);
  }
  return Object.keys(stages).filter((name) => names.length === 0 || names.includes(name));
}

function requireSystem() {
  const missing = ensureSystem('which the tests need');
  if (missing.length === 0) return;
  throw new SetupError(
    `${missing.join(', ')} missing: see the line above. Without them: npm test -- check unit oracle`,
  );
}

/** Runs all steps of a stage, also after one that fails. */
function runStage(name, judges) {
  console.log(`\n\x1b[1m── ${name}\x1b[0m`);
  const { steps, needs = [] } = stages[name];
  const reason = needs.includes('build') ? buildFailure() : undefined;
  if (reason !== undefined) return fail(name, `NOT RUN: ${reason}`);
  const began = Date.now();
  const env = { ...process.env, ...(judges && { PATH: `${judges}${delimiter}${process.env.PATH}` }) };
  const failed = steps.filter(({ path, args }) => {
    const { status } = spawnSync(process.execPath, [path, ...args], { cwd: root, stdio: 'inherit', env });
    return status !== 0;
  });
  const seconds = `${((Date.now() - began) / 1000).toFixed(0)} s`;
  const names = failed.map(({ path, args }) => [basename(path), ...args].join(' '));
  if (failed.length > 0) return fail(name, `FAILED in ${seconds}: ${names.join('; ')}`);
  const partly = needs.includes('python') && !judges;
  const without = partly ? '; comparisons with other programs SKIPPED: they need Python 3 with venv, and PyPI' : '';
  results.push([name, `passed in ${seconds}${without}`]);
}

function fail(name, result) {
  results.push([name, result]);
  process.exitCode = 1;
}

/** Builds once, before the first stage that needs it; returns why it failed. */
function buildFailure() {
  if (build === undefined)
    try {
      ensureBuilt('lib', 'app', 'api');
      build = {};
    } catch (error) {
      if (!(error instanceof SetupError)) throw error;
      build = { failure: error.message };
    }
  return build.failure;
}

function summarize() {
  if (results.length === 0) return;
  console.log('\n\x1b[1m── summary\x1b[0m');
  for (const [name, result] of results) console.log(`${name.padEnd(8)}${result}`);
}
