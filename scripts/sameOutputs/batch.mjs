// A process of `npm run sameOutputs`: runs jobs of bin/slowlight.js one after another, which takes half the time of one
// process per picture.
import { appendFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Path of bin/slowlight.js, and a JSON file with the jobs: a working folder and commands each. */
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
  // Written last: a folder without it belongs to a job that terminated the process.
  writeFileSync(join(folder, 'exits.json'), JSON.stringify({ exits, seconds: (performance.now() - began) / 1000 }));
}
process.exitCode = 0;

/** Appends output to a file immediately, so that it survives if the process ends early. */
function capture(stream, file) {
  writeFileSync(file, '');
  stream.write = (chunk, encoding, done = encoding) => {
    appendFileSync(file, chunk);
    if (typeof done === 'function') done();
    return true;
  };
}

/** The query makes Node evaluate the file again; the modules that it imports stay cached. */
async function runProgram(args) {
  process.argv = [process.execPath, program, ...args];
  process.exitCode = undefined;
  process.stdout.removeAllListeners('error');
  runs += 1;
  await import(`${address}?run=${runs}`);
  return Number(process.exitCode ?? 0);
}
