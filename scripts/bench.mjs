// `npm run bench`: measures this machine and writes docs/performance.md. `npm run bench -- NAME …` runs some and writes nothing, with `--renew` their parts of the page.
import { join } from 'node:path';
import { checkNode, ensureBuilt, ensureModules, root, run, SetupError } from './setup.mjs';

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib', 'app');
  run(process.execPath, [join(root, 'node_modules/typescript/bin/tsc'), '-p', 'bench/tsconfig.json']);
  run(process.execPath, ['--expose-gc', join(root, 'dist/bench/bench/main.js'), ...process.argv.slice(2)]);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run bench: ${error.message}`);
  process.exit(1);
}
