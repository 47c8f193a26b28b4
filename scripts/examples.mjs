// `npm run examples`: regenerates every scene in examples/. `npm run examples -- street dice` only some.
import { join } from 'node:path';
import { checkNode, ensureModules, root, run, SetupError } from './setup.mjs';

try {
  checkNode();
  ensureModules();
  run(process.execPath, [join(root, 'node_modules/typescript/bin/tsc'), '-p', 'examples/tsconfig.json']);
  run(process.execPath, [join(root, 'dist/examples/examples/main.js'), ...process.argv.slice(2)]);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run examples: ${error.message}`);
  process.exit(1);
}
