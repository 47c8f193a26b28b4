// `npm run docs`: makes docs/guide/formats.md anew from what the readers say and do.
import { join } from 'node:path';
import { checkNode, ensureModules, root, run, SetupError } from './setup.mjs';

try {
  checkNode();
  ensureModules();
  run(process.execPath, [
    join(root, 'node_modules/vitest/vitest.mjs'),
    'run',
    '-u',
    '--project',
    'unit',
    'tests/formats/coverage.test.ts',
  ]);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run docs: ${error.message}`);
  process.exit(1);
}
