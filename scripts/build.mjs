// `npm run build`: the library with the command line (lib), the page (app), and the pages of the library's API (api). `npm run build -- lib` builds one of them.
import { checkNode, ensureBuilt, ensureModules, SetupError } from './setup.mjs';

try {
  checkNode();
  ensureModules();
  const names = process.argv.slice(2);
  ensureBuilt(...(names.length > 0 ? names : ['lib', 'app', 'api']));
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run build: ${error.message}`);
  process.exit(1);
}
