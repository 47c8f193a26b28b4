// `npm start`: from a fresh clone to the program in a browser. Options after `--` go to `slowlight serve`.
import { checkNode, ensureBuilt, ensureModules, ensureSystem, SetupError, say } from './setup.mjs';

try {
  checkNode();
  ensureModules();
  tryEnsureSystem();
  ensureBuilt('lib', 'app');
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm start: ${error.message}`);
  process.exit(1);
}
const { main } = await import('../dist/lib/cli/main.js');
process.exitCode = await main(['serve', ...process.argv.slice(2)]);

/** The page needs no system packages and starts without them; `slowlight render` and `npm test` need them. */
function tryEnsureSystem() {
  try {
    ensureSystem('for rendering on the command line and for the tests');
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    say(`${error.message} The page works without; rendering on the command line may not.`);
  }
}
