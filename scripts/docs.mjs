// `npm run docs`: regenerates docs/guide/formats.md, nodes.md and the tables of flags in command-line.md from the code, and biome.imports.json from ADR 1.
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
    'tests/docs/generatedPages.test.ts',
    'tests/docs/folders.test.ts',
  ]);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run docs: ${error.message}`);
  process.exit(1);
}
