// Report of `npm run sameOutputs` on the outputs of both sides.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { differing, resultIn } from './run.mjs';

/** Files whose first differing line is printed. */
const TEXT_FILES = ['.usda', '.gltf', '.obj', '.mtl', '.csv', '.json', '.stdout'];

/** Prints how the sides differ; returns the exit code. Equal outputs are deleted. */
export function report(jobs, before, now) {
  const differences = [];
  const totals = new Map();
  for (const job of jobs) {
    const [a, b] = [before, now].map(({ place }) => resultIn(place(job)));
    const data = differing(a.data, b.data);
    // Text is reported only if the data are equal.
    const texts = differing(a.texts, b.texts).filter((name) => !data.includes(name));
    differences.push(...data.map((name) => ({ job, name, isData: true })));
    differences.push(...texts.map((name) => ({ job, name, isData: false })));
    const total = totals.get(job.kind) ?? { jobs: 0, outputs: 0, different: 0, texts: 0, before: 0, now: 0 };
    total.jobs += 1;
    total.outputs += Object.keys(a.data).length;
    total.different += data.length;
    total.texts += texts.length;
    total.before += a.seconds;
    total.now += b.seconds;
    totals.set(job.kind, total);
    if (data.length + texts.length === 0) rmSync(now.place(job), { recursive: true });
  }
  printTotals(totals);
  const changed = differences.filter(({ isData }) => isData);
  if (changed.length > 0) printData(changed, before, now);
  if (changed.length < differences.length) printTexts(differences, before, now);
  if (differences.length === 0) rmSync(now.folder, { recursive: true });
  const outputs = [...totals.values()].reduce((sum, each) => sum + each.outputs, 0);
  console.log(
    changed.length === 0
      ? `\nAll ${outputs} outputs of ${jobs.length} jobs are the same to the bit as those of ${before.name}.`
      : `\n${changed.length} of ${outputs} outputs differ from those of ${before.name}; those of the working tree are in ${now.folder}`,
  );
  return changed.length === 0 ? 0 : 1;
}

function printTotals(totals) {
  const columns = ['jobs', 'outputs', 'different', 'texts'];
  console.log(`\n${'kind'.padEnd(11)}${columns.map((name) => name.padStart(10)).join('')}   seconds before, now`);
  for (const [kind, total] of totals) {
    const counts = columns.map((name) => String(total[name]).padStart(10)).join('');
    console.log(`${kind.padEnd(11)}${counts}   ${total.before.toFixed(0)}, ${total.now.toFixed(0)}`);
  }
}

function printData(differences, before, now) {
  console.log('\nDifferent outputs');
  for (const { job, name } of differences) {
    const [a, b] = [before, now].map(({ place }) => join(place(job), name));
    console.log(`  ${job.id}: ${name}: ${whereDifferent(name, a, b, [before, now], job)}`);
    console.log(`    ${a}\n    ${b}`);
  }
}

function whereDifferent(name, a, b, sides, job) {
  if (name === 'exit codes') {
    const [was, is] = sides.map(({ place }) => JSON.parse(readFileSync(join(place(job), 'exits.json'), 'utf8')).exits);
    return `${was.join(' ')} became ${is.join(' ')}`;
  }
  if (!existsSync(a)) return 'written now only';
  if (!existsSync(b)) return 'not written now';
  const [x, y] = [readFileSync(a), readFileSync(b)];
  if (!TEXT_FILES.includes(extname(name))) return firstByte(x, y);
  const [lines, others] = [x, y].map((bytes) => bytes.toString().split('\n'));
  const at = lines.findIndex((line, i) => line !== others[i]);
  const shown = (line = '(end)') => JSON.stringify(line.slice(0, 100));
  return `line ${at + 1}: ${shown(lines[at])} became ${shown(others[at])}`;
}

function firstByte(x, y) {
  const at = x.findIndex((byte, i) => byte !== y[i]);
  return x.length === y.length ? `from byte ${at} of ${x.length}` : `${x.length} bytes became ${y.length}`;
}

/** Collects text differences in one file, by `git diff`. */
function printTexts(differences, before, now) {
  const texts = differences.filter(({ isData }) => !isData);
  const shown = texts.map(({ job, name }) => {
    const [a, b] = [before, now].map(({ place }) => join(place(job), name));
    const files = [a, b].map((file) => (existsSync(file) ? file : '/dev/null'));
    const { stdout } = spawnSync('git', ['diff', '--no-index', '--no-color', '-U0', ...files], { encoding: 'utf8' });
    const lines = stdout.split('\n').filter((line) => /^[-+](?!(--|\+\+) )/.test(line));
    return [`${job.id}: ${name}`, ...lines].join('\n');
  });
  const file = join(now.folder, 'texts.diff');
  writeFileSync(file, `${shown.join('\n\n')}\n`);
  console.log(`\n${texts.length} texts are others (no failure): ${file}`);
}
