import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, totalmem } from 'node:os';
import { fileURLToPath } from 'node:url';
import { formats } from './formats/formats.ts';
import { load } from './formats/load.ts';
import { bundle } from './page/bundle.ts';
import { diagram } from './page/diagram.ts';
import { firstPicture } from './page/firstPicture.ts';
import { graph } from './page/graph.ts';
import { graphPage } from './page/graphPage.ts';
import { weak } from './page/weak.ts';
import { noise } from './reference/noise.ts';
import { reference } from './reference/reference.ts';
import { antialiasing } from './rendering/antialiasing.ts';
import { capture } from './rendering/capture.ts';
import { cubic } from './rendering/cubic.ts';
import { effects } from './rendering/effects.ts';
import { emission } from './rendering/emission.ts';
import { films } from './rendering/films.ts';
import { frame } from './rendering/frame.ts';
import { immersive } from './rendering/immersive.ts';
import { instances } from './rendering/instances.ts';
import { lean } from './rendering/lean.ts';
import { lenses } from './rendering/lenses.ts';
import { memory } from './rendering/memory.ts';
import { outside } from './rendering/outside.ts';
import { tessellation } from './rendering/tessellation.ts';
import { views } from './rendering/views.ts';
import { cache } from './simulation/cache.ts';
import { computing } from './simulation/compute.ts';
import { dynamics } from './simulation/dynamics.ts';
import { type Bench, markdown } from './support/bench.ts';
import { gpu, releaseGpu } from './support/gpu.ts';

/** All benchmarks, in the order of the page. */
const benches: readonly Bench[] = [
  frame,
  lean,
  immersive,
  views,
  outside,
  lenses,
  capture,
  films,
  antialiasing,
  cubic,
  tessellation,
  emission,
  effects,
  memory,
  formats,
  load,
  instances,
  cache,
  reference,
  noise,
  dynamics,
  computing,
  graph,
  graphPage,
  diagram,
  firstPicture,
  weak,
  bundle,
];

const file = fileURLToPath(new URL('../../../docs/performance.md', import.meta.url));
const [BEGIN, END] = ['<!-- measured: npm run bench -->', '<!-- end -->'];

/** Writes the figures of the named benchmarks into the page, beside those of the others. */
const RENEW = '--renew';

const words = process.argv.slice(2).filter((word) => word !== RENEW);
const renews = process.argv.includes(RENEW);
/** Files of the person's own, which `load` opens. */
const files = words.filter((word) => existsSync(word));
const names = words.filter((word) => !existsSync(word));
const unknown = names.filter((name) => !benches.some((bench) => bench.name === name));
if (unknown.length > 0) {
  console.error(`no benchmark ${unknown.join(', ')}; there are:`);
  for (const bench of benches) console.error(`  ${bench.name.padEnd(10)}${bench.title}`);
  process.exit(2);
}

const written = readPage();
const here = await machine();
if (renews && written.machine !== here) {
  console.error(
    `${file} has the figures of another machine; without ${RENEW} and names all are measured.\n  ${written.machine}\n  ${here}`,
  );
  process.exit(2);
}
const parts = new Map(renews ? written.parts : []);
for (const bench of benches) {
  if (names.length > 0 && !names.includes(bench.name)) continue;
  console.error(`${bench.title} …`);
  const tables = await bench.run(files);
  const part = [bench.about, ...tables.map(markdown)].join('\n\n');
  console.log(`\n### ${bench.title}\n\n${part}`);
  parts.set(bench.title, part);
}
await releaseGpu();
if (names.length === 0 || renews) publish();

async function machine(): Promise<string> {
  const { adapterName, software } = await gpu();
  const [cpu] = cpus();
  const memory = `${(totalmem() / 2 ** 30).toFixed(0)} GiB`;
  const kind = software ? 'a **software GPU**: ' : '';
  return `Measured on ${cpus().length} × ${cpu.model.trim()}, ${memory}, Node ${process.versions.node}, ${process.platform}; GPU: ${kind}${adapterName}. Medians; compare the ratios, not the times, with another machine.`;
}

/** The page: what is written by hand before and after the figures, the machine, and the parts by their titles. */
function readPage() {
  const text = existsSync(file) ? readFileSync(file, 'utf8') : `# Performance\n\n${BEGIN}\n${END}\n`;
  const [from, to] = [text.indexOf(BEGIN), text.indexOf(END)];
  if (from < 0 || to < from) throw new Error(`${file} has lost its markers ${BEGIN} … ${END}`);
  const [machine = '', ...parts] = text.slice(from + BEGIN.length, to).split(/^### /m);
  return {
    before: text.slice(0, from + BEGIN.length),
    after: text.slice(to),
    machine: machine.trim(),
    parts: parts.map((part): readonly [string, string] => {
      const end = part.indexOf('\n');
      return [part.slice(0, end), part.slice(end).trim()];
    }),
  };
}

/** In the order of the benchmarks. */
function publish(): void {
  const ordered = benches.flatMap(({ title }) => {
    const part = parts.get(title);
    return part === undefined ? [] : [`### ${title}\n\n${part}`];
  });
  writeFileSync(file, `${written.before}\n${[here, ...ordered].join('\n\n')}\n${written.after}`);
}
