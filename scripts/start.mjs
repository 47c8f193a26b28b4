// `npm start`: from a fresh clone to the program in a browser. Options after `--` go to `slowlight serve`.
import { spawn } from 'node:child_process';
import { constants, setPriority } from 'node:os';
import { fileURLToPath } from 'node:url';
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
makeApiPages();
const { main } = await import('../dist/lib/cli/main.js');
process.exitCode = await main(['serve', ...process.argv.slice(2)]);

/** Beside the server: nobody waits for them, and they need packages of their own. */
function makeApiPages() {
  const build = spawn(process.execPath, [fileURLToPath(new URL('build.mjs', import.meta.url)), 'api'], {
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  build.unref();
  build.stderr.unref();
  const said = [];
  build.stderr.on('data', (text) => said.push(text));
  build.on('exit', (code) => {
    if (code !== 0)
      say(`The pages of the API could not be made; all else works. npm run build -- api\n${said.join('')}`);
  });
  try {
    setPriority(build.pid, constants.priority.PRIORITY_LOW);
  } catch {
    // Not every system lets a program be polite.
  }
}

/** The page needs no system packages and starts without them; `slowlight render` and `npm test` need them. */
function tryEnsureSystem() {
  try {
    ensureSystem('for rendering on the command line and for the tests');
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    say(`${error.message} The page works without; rendering on the command line may not.`);
  }
}
