// `npm run dynamics`: runs the source documents' hanging cloth by all methods and writes docs/dynamics.md anew, with its plots. Takes some minutes on all cores;
// `npm run dynamics -- 0.1` follows a tenth of the time, to see that it works, and writes nothing.
import { writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { checkNode, ensureBuilt, ensureModules, root, SetupError } from './setup.mjs';

/** Points along a side, springs [N/m], weight [m/s²]: those of the sources. */
const CLOTH = { side: 10, stiffness: 1000, gravity: [0, -9.8, 0] };
/** Time [s], speeds of light [m/s], steps [s]. */
const TIME = 2;
const SPEEDS = [1, 10, 100];
const STEPS = [1e-3, 5e-4, 1e-4];
/** The energy is looked at so often [s]. */
const EVERY = 0.01;
/** What is followed for long, at which step [s]; for so many steps. */
const LONG = [
  ['discrete-gradient', 1e-3],
  ['implicit-midpoint', 1e-3],
  ['leapfrog', 2.5e-4],
  ['yoshida-4', 2.5e-4],
  ['yoshida-6', 2.5e-4],
  ['yoshida-8', 2.5e-4],
];
const LONG_STEPS = 100_000;
/** Whose energy is to be the same to 10⁻⁹, and whose is to swing without a trend. */
const EXACT = 'discrete-gradient';
/** Parts that a long run is cut into: their means are what its trend is fitted to. */
const PARTS = 25;

const WHY = {
  light: 'passes c',
  indefinite: 'matrix gives out',
  unsolved: 'not solved',
  infinite: 'explodes',
  unstable: 'explodes',
};

const ABOUT = `# A cloth by all methods

The source documents' cloth: ${CLOTH.side} × ${CLOTH.side} points, a metre and a kilogram, springs of ${CLOTH.stiffness} N/m along edges, across faces and to the next neighbour, weight 9.8 m/s², without damping.
It hangs at two corners and is let go level, for ${TIME} s. Its fastest swing has ω = 1550/s, so that h = 1 ms is three quarters of what an explicit method can take. Made by \`npm run dynamics\`.

Each cell tells how far the energy went from what it was at the start, over the largest kinetic energy that the cloth truly has (${EXACT}, h = ${STEPS.at(-1) * 1000} ms): at most, and what became of it.
*Explodes*: more than all of it came from nowhere; *passes c*: a point was given the speed of light or more; *matrix gives out*: it is not positive definite any more; *fades* and *grows*: more than a twentieth was lost or gained at the end.
The numbers behind the methods of the sources are their corrections of the energy: 0 none, 1 by the tangent, 2 by the secant, 3 by the root between them. The last column is the time that a step of ${STEPS.at(-1) * 1000} ms took to compute, in the quickest tenth of the run.
`;

/** What takes longest first, so that all cores end at about the same time. */
async function orders(ids, share) {
  const short = ids.flatMap((id) =>
    SPEEDS.flatMap((c) => STEPS.map((h) => ({ id, c, h, every: EVERY, duration: TIME * share }))),
  );
  const long = LONG.map(([id, h]) => {
    const duration = LONG_STEPS * h * share;
    return { id, c: 10, h, duration, every: duration / 1000, long: true };
  });
  const weight = ({ id, duration, h }) => (duration / h) * (id.startsWith('local') ? 20 : id.startsWith('lin') ? 4 : 1);
  return [...long, ...short].sort((a, b) => weight(b) - weight(a));
}

/** Gives each thread the next order when it is done with one. */
async function studied(queue) {
  const all = queue.length;
  const results = [];
  const next = queue.values();
  const thread = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL('./dynamicsCase.mjs', import.meta.url), { workerData: CLOTH });
      let order;
      worker.on('error', reject);
      worker.on('message', (result) => {
        if (result) results.push({ ...result, long: order.long });
        process.stderr.write(`\r${results.length} of ${all} runs `);
        order = next.next().value;
        if (order) worker.postMessage(order);
        else worker.terminate().then(resolve, reject);
      });
    });
  await Promise.all(Array.from({ length: availableParallelism() }, thread));
  process.stderr.write('\n');
  return results;
}

const find = (results, id, c, h) =>
  results.find((each) => !each.long && each.id === id && each.c === c && each.h === h);

/** The largest kinetic energy of the cloth, which errors are measured by: by the method that keeps the energy, at its shortest step [J]. */
const scaleOf = (results, c) => find(results, EXACT, c, STEPS.at(-1)).kinetic;

const kindOf = (id) => (/-[0-3]$/.test(id) && !id.startsWith('yoshida') ? 'sources' : 'ours');

const sizeOf = (most) => (most < 1e-2 ? power(most) : `${(100 * most).toPrecision(2)} %`);

function power(value) {
  const [digits, exponent] = value.toExponential(0).split('e');
  return `${digits} · 10${[...String(Number(exponent))].map((sign) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(sign)]).join('')}`;
}

/** What became of a run's energy: in a word, and when it was lost. */
function fate({ energies, every, stop }, scale) {
  const off = energies.map((energy) => (energy - energies[0]) / scale);
  const most = Math.max(...off.map(Math.abs));
  const out = off.findIndex((value) => Math.abs(value) > 1);
  if (out >= 0) return { word: 'explodes', most, t: out * every };
  if (stop) return { word: WHY[stop.reason] ?? stop.reason, most, t: stop.t };
  if (off.at(-1) < -0.05) return { word: 'fades', most };
  return { word: off.at(-1) > 0.05 ? 'grows' : '', most };
}

function verdict(result, scale) {
  const { word, most, t } = fate(result, scale);
  if (t !== undefined) return `**${word}** at ${t.toFixed(2)} s`;
  return word ? `${word}, ${sizeOf(most)}` : sizeOf(most);
}

function written(results) {
  const ids = [...new Set(results.map(({ id }) => id))].sort(
    (a, b) => kindOf(a).localeCompare(kindOf(b)) || a.localeCompare(b),
  );
  const tables = SPEEDS.map((c) => {
    const rows = ids.map((id) => {
      const cells = STEPS.map((h) => verdict(find(results, id, c, h), scaleOf(results, c)));
      const { ms } = find(results, id, c, STEPS.at(-1));
      return `| ${id} | ${cells.join(' | ')} | ${ms.toPrecision(2)} |`;
    });
    const head = `| method | ${STEPS.map((h) => `h = ${h * 1000} ms`).join(' | ')} | ms a step |`;
    const plotted = `![Energy over time, c = ${c} m/s](pictures/energy-${c}.svg)`;
    return [`## c = ${c} m/s`, '', head, `|${'---|'.repeat(STEPS.length + 2)}`, ...rows, '', plotted, ''].join('\n');
  });
  return [ABOUT, summary(results), ...tables, longTable(results)].join('\n');
}

/** How many of the runs of each kind came to what. */
function summary(results) {
  const line = (kind, who) => {
    const fates = results
      .filter(({ id, long }) => !long && kindOf(id) === kind)
      .map((result) => fate(result, scaleOf(results, result.c)));
    const count = (test) => fates.filter(test).length;
    const kept = count(({ word, most }) => !word && most < 0.01);
    const ends = count(({ t }) => t !== undefined);
    const [fade, grow] = ['fades', 'grows'].map((name) => count(({ word }) => word === name));
    return `- ${who}: of ${fates.length} runs ${ends} end early (they explode, pass c, or their matrix gives out), ${fade} fade, ${grow} grow; ${kept} keep the energy to a hundredth.`;
  };
  return ['## In short', '', line('sources', 'The methods of the sources'), line('ours', 'Ours'), ''].join('\n');
}

/** Of a long run: how far the energy was off at most, over the kinetic energy, and the slope of a line through the means of its parts, with its standard error [1/s]. */
function trend({ energies, every, kinetic }) {
  const off = energies.map((energy) => (energy - energies[0]) / kinetic);
  const size = Math.floor(off.length / PARTS);
  const means = Array.from({ length: PARTS }, (_, k) => mean(off.slice(k * size, (k + 1) * size)));
  const times = means.map((_, k) => (k + 0.5) * size * every);
  const [t0, m0] = [mean(times), mean(means)];
  const spread = times.reduce((sum, t) => sum + (t - t0) ** 2, 0);
  const slope = times.reduce((sum, t, k) => sum + (t - t0) * (means[k] - m0), 0) / spread;
  const left = means.reduce((sum, value, k) => sum + (value - m0 - slope * (times[k] - t0)) ** 2, 0);
  return { most: Math.max(...off.map(Math.abs)), slope, error: Math.sqrt(left / (PARTS - 2) / spread) };
}

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function longTable(results) {
  const rows = LONG.map(([id, h]) => {
    const result = results.find((each) => each.long && each.id === id);
    const { most, slope, error } = trend(result);
    const drift = `(${slope.toExponential(1)} ± ${error.toExponential(1)})/s`;
    const claim =
      id === EXACT
        ? most <= 1e-9
          ? 'kept: at most 10⁻⁹'
          : '**not kept**'
        : Math.abs(slope) < 3 * error
          ? 'no trend'
          : '**a trend**';
    return `| ${id} | ${h * 1000} ms | ${result.steps.toLocaleString('en')} | ${sizeOf(most)} | ${drift} | ${claim} |`;
  });
  return [
    '## For long',
    '',
    `The same cloth at c = 10 m/s for ${LONG_STEPS.toLocaleString('en')} steps. *Off at most*: |ΔE| over the largest kinetic energy. *Trend*: slope of a line through the means of ${PARTS} parts of the run, with its standard error; below three of these there is none.`,
    '',
    '| method | h | steps | off at most | trend | |',
    '|---|---|---|---|---|---|',
    ...rows,
    '',
    '![Energy over time, for long](pictures/energy-long.svg)',
    '',
  ].join('\n');
}

const [WIDTH, HEIGHT, LEFT, TOP, LEGEND, FOOT] = [820, 330, 64, 34, 210, 46];
/** Okabe and Ito's, which the colour-blind tell apart. */
const COLORS = ['#d55e00', '#e69f00', '#cc79a7', '#56b4e9', '#009e73', '#000000'];

/** The energy over time of a method of each kind, at the longest step. */
function plot(results, c) {
  const h = STEPS[0];
  const scale = scaleOf(results, c);
  const curves = [
    'semi-implicit-euler-0',
    'semi-implicit-euler-2',
    'linearly-implicit-0',
    'linearly-implicit-2',
    'leapfrog',
    EXACT,
  ].map((id) => {
    const result = find(results, id, c, h);
    const off = result.energies.map((energy) => (energy - result.energies[0]) / scale);
    const { t, word } = fate(result, scale);
    return { name: id, off, every: result.every, end: t === undefined ? undefined : `${word}, ${t.toFixed(2)} s` };
  });
  const title = `What energy is too much, over the largest kinetic energy: c = ${c} m/s, h = ${h * 1000} ms`;
  return drawn(curves, title, TIME, 1.2, [-1, -0.5, 0, 0.5, 1]);
}

/** Of the splittings, over 10⁵ steps. */
function longPlot(results) {
  const curves = LONG.filter(([, h]) => h === LONG[2][1]).map(([id]) => {
    const { energies, kinetic, every } = results.find((each) => each.long && each.id === id);
    return { name: id, off: energies.map((energy) => (energy - energies[0]) / kinetic), every };
  });
  const most = Math.max(...curves.flatMap(({ off }) => off.map(Math.abs)));
  const tick = 10 ** Math.floor(Math.log10(most));
  const title = `What energy is too much, over the largest kinetic energy: c = 10 m/s, h = ${LONG[2][1] * 1000} ms`;
  return drawn(curves, title, LONG_STEPS * LONG[2][1], 1.2 * most, [-tick, 0, tick]);
}

/** Curves over time; what is beyond `most` goes along the border. */
function drawn(curves, title, time, most, ticks) {
  const x = (t) => LEFT + (t / time) * (WIDTH - LEFT - LEGEND);
  const y = (off) => TOP + ((most - Math.max(-most, Math.min(most, off))) / (2 * most)) * (HEIGHT - TOP - FOOT);
  const text = (at, down, words, more = '') => `<text x="${at}" y="${down}" ${more}>${words}</text>`;
  const rules = ticks.map(
    (off) =>
      `<line x1="${x(0)}" x2="${x(time)}" y1="${y(off)}" y2="${y(off)}" stroke="#ccc"/>${text(x(0) - 8, y(off) + 4, String(off).replace('-', '−'), 'text-anchor="end"')}`,
  );
  const times = [0, 0.25, 0.5, 0.75, 1].map((share) =>
    text(x(share * time), HEIGHT - FOOT + 18, share * time, 'text-anchor="middle"'),
  );
  const lines = curves.map(({ name, off, every, end }, i) => {
    const color = COLORS[i];
    const points = off.map((value, k) => `${x(k * every).toFixed(1)},${y(value).toFixed(1)}`);
    const [last] = points.at(-1).split(',').map(Number);
    const stop = end ? `<circle cx="${last}" cy="${points.at(-1).split(',')[1]}" r="3.5" fill="${color}"/>` : '';
    const down = TOP + 12 + 34 * i;
    const at = WIDTH - LEGEND + 16;
    const key = `<line x1="${at}" x2="${at + 22}" y1="${down - 4}" y2="${down - 4}" stroke="${color}" stroke-width="2.5"/>`;
    const words = text(at + 28, down, name) + (end ? text(at + 28, down + 14, end, 'fill="#555" font-size="11"') : '');
    return `<polyline points="${points.join(' ')}" fill="none" stroke="${color}" stroke-width="1.6"/>${stop}${key}${words}`;
  });
  const axis = text(x(time / 2), HEIGHT - 8, 'time [s]', 'text-anchor="middle"');
  const head = text(LEFT, 18, title, 'font-weight="bold"');
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>${head}${axis}${rules.join('')}${times.join('')}${lines.join('')}</svg>\n`;
}

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib');
  const share = Number(process.argv[2] ?? 1);
  const { METHODS } = await import('../dist/lib/dynamics/index.js');
  const results = await studied(await orders([...METHODS.keys()], share));
  const page = written(results);
  if (share === 1) {
    writeFileSync(join(root, 'docs/dynamics.md'), page);
    for (const c of SPEEDS) writeFileSync(join(root, `docs/pictures/energy-${c}.svg`), plot(results, c));
    writeFileSync(join(root, 'docs/pictures/energy-long.svg'), longPlot(results));
  } else console.log(page);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run dynamics: ${error.message}`);
  process.exit(1);
}
