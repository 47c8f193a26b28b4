// A process of `npm run sameOutputs`: runs jobs of bin/slowlight.js one after another. Loading the program once for many
// pictures takes half the time of starting it anew for each.
import { appendFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** The program bin/slowlight.js, and a JSON file that lists the jobs: each a folder to run in, and its commands. */
const [, , program, list] = process.argv;
const address = pathToFileURL(program).href;
let runs = 0;

for (const { folder, steps } of JSON.parse(readFileSync(list, 'utf8'))) {
  mkdirSync(folder, { recursive: true });
  process.chdir(folder);
  const began = performance.now();
  const exits = [];
  for (const [i, args] of steps.entries()) {
    capture(process.stdout, join(folder, `${i}.stdout`));
    capture(process.stderr, join(folder, `${i}.stderr`));
    exits.push(await runProgram(args));
  }
  // Written last: a folder without it belongs to a job that ended the process.
  writeFileSync(join(folder, 'exits.json'), JSON.stringify({ exits, seconds: (performance.now() - began) / 1000 }));
}
process.exitCode = 0;

/** Appends what is printed to a file at once, so that it is kept where the process ends early. */
function capture(stream, file) {
  writeFileSync(file, '');
  stream.write = (chunk, encoding, done = encoding) => {
    appendFileSync(file, chunk);
    if (typeof done === 'function') done();
    return true;
  };
}

/** The query makes Node evaluate the file again; the modules that it imports stay loaded. */
async function runProgram(args) {
  process.argv = [process.execPath, program, ...args];
  process.exitCode = undefined;
  process.stdout.removeAllListeners('error');
  runs += 1;
  await import(`${address}?run=${runs}`);
  return Number(process.exitCode ?? 0);
}
