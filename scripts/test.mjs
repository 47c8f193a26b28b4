// `npm test`: set-up, then every check and test, the fast ones first; stops at the first failing stage.
// `npm test -- unit cli` runs only some stages.
import { spawnSync } from 'node:child_process';
import { delimiter, join } from 'node:path';
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
try {
  checkNode();
  ensureModules();
  const chosen = choose(process.argv.slice(2));
  const need = new Set(chosen.flatMap((name) => stages[name].needs ?? []));
  if (need.has('system')) requireSystem();
  const judges = need.has('python') ? ensureOracle() : undefined;
  if (need.has('build')) ensureBuilt('lib', 'app');
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

function runStage(name, judges) {
  console.log(`\n\x1b[1m── ${name}\x1b[0m`);
  const began = Date.now();
  const env = { ...process.env, ...(judges && { PATH: `${judges}${delimiter}${process.env.PATH}` }) };
  for (const { path, args } of stages[name].steps) {
    const done = spawnSync(process.execPath, [path, ...args], { cwd: root, stdio: 'inherit', env });
    if (done.status === 0) continue;
    results.push([name, `FAILED (${args.join(' ') || path})`]);
    throw new SetupError(`${name} failed.`);
  }
  const partly = stages[name].needs?.includes('python') && !judges;
  const without = partly ? '; comparisons with other programs SKIPPED: they need Python 3 with venv, and PyPI' : '';
  results.push([name, `passed in ${((Date.now() - began) / 1000).toFixed(0)} s${without}`]);
}

function summarize() {
  if (results.length === 0) return;
  console.log('\n\x1b[1m── summary\x1b[0m');
  for (const [name, result] of results) console.log(`${name.padEnd(8)}${result}`);
}
