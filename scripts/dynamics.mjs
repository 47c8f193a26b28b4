// `npm run dynamics`: runs the source documents' hanging cloth by all methods and writes docs/dynamics.md anew, with its plots. Takes some minutes on all cores;
// `npm run dynamics -- 0.1` follows a tenth of the time, to see that it works, and writes nothing.
import { writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { checkNode, ensureBuilt, ensureModules, root, SetupError } from './setup.mjs';

/** Points along a side, springs [N/m], weight [m/s²]: those of the sources. */
const SIDE = 10;
const CLOTH = { stiffness: 1000, gravity: [0, -9.8, 0] };
/** Time [s], speeds of light [m/s], steps [s]. */
const TIME = 2;
const SPEEDS = [1, 10, 100, Number.POSITIVE_INFINITY];
const STEPS = [1e-3, 5e-4, 1e-4];
/** The energy is looked at so often [s]. */
const EVERY = 0.01;
/** The runs that the documents name, c [m/s] and h [s], what they tell of them, and how long and of how many points along a side these are run here: they do not say. */
const TOLD = [
  ['semi-implicit-euler-0', 10, 1e-3, 'wrong midway, then gone'],
  ['semi-implicit-euler-0', 100, 1e-4, 'decent for a time, with jitter'],
  ['semi-implicit-euler-1', 10, 1e-4, 'explodes, however short the steps'],
  ['semi-implicit-euler-1', 100, 1e-4, 'explodes, however short the steps'],
  ['semi-implicit-euler-2', 10, 5e-4, 'explodes after a long time'],
  ['semi-implicit-euler-2', 100, 1e-3, 'explodes after a long time'],
  ['semi-implicit-euler-0', Number.POSITIVE_INFINITY, 1e-3, 'large motion'],
  ['linearly-implicit-0', 10, 1e-3, 'explodes as its matrix gives out'],
  ['linearly-implicit-1', 10, 1e-3, 'explodes'],
  ['linearly-implicit-2', 10, 1e-3, 'no explosion; fades'],
  ['linearly-implicit-2', 1, 1e-3, 'works well'],
  ['linearly-implicit-0', Number.POSITIVE_INFINITY, 1e-3, 'somewhat smaller motion'],
];
const TOLD_TIME = 5;
const TOLD_SIDES = [10, 20];
/** What the documents' programs leave of all velocities in every step, and the methods that they ran with it. */
const DAMPING = 0.995;
const DAMPED = /^(semi-implicit-euler|linearly-implicit)-/;
/** Over the kinetic energy: less is rounding. */
const LEAST_GAIN = 1e-6;
/** Time in which each method's cost is measured when all else is done, in so many parts, and so often [s]: before any of them ends early. */
const [TIMED, TIMED_PARTS, TIMED_OFTEN] = [0.6, 30, 3];
/** c of what is followed for long [m/s], and for so many steps. */
const LONG = 10;
const LONG_STEPS = 100_000;
/** Whose energy is to be the same to 10⁻⁹: the cloth, let go at rest. */
const EXACT = 'discrete-gradient';
const EXACT_STEP = 1e-3;
/** Whose energy is to swing without a trend: a smaller cloth, shaken so that all its swings have their share, once it has settled for so many times as long. */
const SWINGING = ['leapfrog', 'yoshida-4', 'yoshida-6', 'yoshida-8', 'implicit-midpoint'];
const [SWINGING_STEP, SWINGING_SIDE, SHAKEN, SETTLING] = [5e-4, 5, 3, 4];
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

The source documents' cloth: ${SIDE} × ${SIDE} points, a metre and a kilogram, springs of ${CLOTH.stiffness} N/m along edges, across faces and to the next neighbour, weight 9.8 m/s², without damping.
It hangs at two corners and is let go level, for ${TIME} s. Its fastest swing has ω = 1550/s, so that h = 1 ms is three quarters of what an explicit method can take. Made by \`npm run dynamics\`.

Each cell tells how far the energy went from what it was at the start, over the largest kinetic energy that the cloth truly has (${EXACT}, h = ${STEPS.at(-1) * 1000} ms): at most, and what became of it.
*Explodes*: more than all of it came from nowhere; *passes c*: a point was given the speed of light or more; *matrix gives out*: it is not positive definite any more; *fades* and *grows*: more than a twentieth was lost or gained at the end.
The numbers behind the methods of the sources are their corrections of the energy: 0 none, 1 by the tangent, 2 by the secant, 3 by the root between them. The last column is the time that a step of ${STEPS.at(-1) * 1000} ms took to compute when all else was done: the median of ${TIMED_PARTS} parts of ${TIMED} s of motion, each the quickest of ${TIMED_OFTEN} times.
`;

/** What takes longest first, so that all cores end at about the same time. */
async function orders(ids, share) {
  const short = ids.flatMap((id) =>
    SPEEDS.flatMap((c) => STEPS.map((h) => ({ id, c, h, side: SIDE, every: EVERY, duration: TIME * share }))),
  );
  const damped = short
    .filter(({ id, c }) => DAMPED.test(id) && Number.isFinite(c))
    .map((order) => ({ ...order, drag: -Math.log(DAMPING) / order.h, kind: 'damped' }));
  const told = TOLD.flatMap(([id, c, h]) =>
    TOLD_SIDES.map((side) => ({ id, c, h, side, every: EVERY, duration: TOLD_TIME * share, kind: 'told' })),
  );
  const lasting = (id, h, times) => {
    const measured = LONG_STEPS * h * share;
    return { id, c: LONG, h, duration: times * measured, every: measured / 1000 };
  };
  const long = [
    { ...lasting(EXACT, EXACT_STEP, 1), side: SIDE, kind: 'long', about: 'at rest' },
    { ...lasting(SWINGING[0], SWINGING_STEP / 2, 1), side: SIDE, kind: 'long', about: 'at rest' },
    ...SWINGING.map((id) => ({
      ...lasting(id, SWINGING_STEP, SETTLING + 1),
      side: SWINGING_SIDE,
      shaken: SHAKEN,
      kind: 'long',
      about: 'shaken',
    })),
  ];
  const weight = ({ id, duration, h }) => (duration / h) * (id.startsWith('local') ? 20 : id.startsWith('lin') ? 4 : 1);
  return [...long, ...short, ...damped, ...told].sort((a, b) => weight(b) - weight(a));
}

/** One after the other, all of them several times: what steps cost where nothing else runs. */
const timings = (ids) =>
  Array.from({ length: TIMED_OFTEN }, () => ids).flatMap((round) =>
    round.flatMap((id) =>
      SPEEDS.map((c) => ({
        ...{ id, c, h: STEPS.at(-1), side: SIDE },
        ...{ every: TIMED / TIMED_PARTS, duration: TIMED, kind: 'timed' },
      })),
    ),
  );

/** What a step cost [ms]. */
function costOf(results, id, c) {
  const [first, ...others] = results.filter((each) => each.kind === 'timed' && each.id === id && each.c === c);
  const quickest = first.costs.map((cost, k) => Math.min(cost, ...others.map(({ costs }) => costs[k])));
  return quickest.sort((a, b) => a - b)[Math.floor(quickest.length / 2)];
}

/** Gives each of so many threads the next order when it is done with one. */
async function studied(queue, threads) {
  const all = queue.length;
  const results = [];
  const next = queue.values();
  const thread = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL('./dynamicsCase.mjs', import.meta.url), { workerData: CLOTH });
      let order;
      worker.on('error', reject);
      worker.on('message', (result) => {
        if (result) results.push({ ...result, side: order.side, kind: order.kind, about: order.about });
        process.stderr.write(`\r${results.length} of ${all} runs `);
        order = next.next().value;
        if (order) worker.postMessage(order);
        else worker.terminate().then(resolve, reject);
      });
    });
  await Promise.all(Array.from({ length: threads }, thread));
  process.stderr.write('\n');
  return results;
}

const find = (results, id, c, h, kind) =>
  results.find((each) => each.kind === kind && each.id === id && each.c === c && each.h === h);

/** The largest kinetic energy of the cloth, which errors are measured by: by the method that keeps the energy, at its shortest step [J]. */
const scaleOf = (results, c) => find(results, EXACT, c, STEPS.at(-1)).kinetic;

const kindOf = (id) => (/-[0-3]$/.test(id) && !id.startsWith('yoshida') ? 'sources' : 'ours');

const sizeOf = (most) => (most < 1e-2 ? power(most) : `${(100 * most).toPrecision(2)} %`);

function power(value) {
  const [digits, exponent] = value
    .toExponential(0)
    .replace('-', value < 0 ? '−' : '-')
    .split('e');
  return `${digits} · 10${[...String(Number(exponent))].map((sign) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(sign)]).join('')}`;
}

/** What became of a run's energy: in a word, and when it was lost. */
function fate({ energies, every, stop }, scale) {
  const off = errors(energies, scale);
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

const lightOf = (c) => (Number.isFinite(c) ? `c = ${c} m/s` : 'c = ∞: Newton’s mechanics');
const pictureOf = (c) => `pictures/energy-${Number.isFinite(c) ? c : 'newton'}.svg`;

function written(results) {
  const ids = [...new Set(results.map(({ id }) => id))].sort(
    (a, b) => kindOf(a).localeCompare(kindOf(b)) || a.localeCompare(b),
  );
  const tables = SPEEDS.map((c) => {
    const rows = ids.map((id) => {
      const cells = STEPS.map((h) => verdict(find(results, id, c, h), scaleOf(results, c)));
      return `| ${id} | ${cells.join(' | ')} | ${costOf(results, id, c).toPrecision(2)} |`;
    });
    const head = `| method | ${STEPS.map((h) => `h = ${h * 1000} ms`).join(' | ')} | ms a step |`;
    const plotted = `![Energy over time, ${lightOf(c)}](${pictureOf(c)})`;
    return [`## ${lightOf(c)}`, '', head, `|${'---|'.repeat(STEPS.length + 2)}`, ...rows, '', plotted, ''].join('\n');
  });
  return [ABOUT, summary(results), ...tables, toldTable(results), dampedRuns(results), longTable(results)].join('\n');
}

/** How many of the runs of each kind came to what. */
function summary(results) {
  const line = (kind, who) => {
    const fates = results
      .filter((result) => result.kind === undefined && kindOf(result.id) === kind)
      .map((result) => fate(result, scaleOf(results, result.c)));
    const count = (test) => fates.filter(test).length;
    const kept = count(({ word, most }) => !word && most < 0.01);
    const ends = count(({ t }) => t !== undefined);
    const [fade, grow] = ['fades', 'grows'].map((name) => count(({ word }) => word === name));
    return `- ${who}: of ${fates.length} runs ${ends} end early (they explode, pass c, or their matrix gives out), ${fade} fade, ${grow} grow; ${kept} keep the energy to a hundredth.`;
  };
  return ['## In short', '', line('sources', 'The methods of the sources'), line('ours', 'Ours'), ''].join('\n');
}

/** Of a long run, over the kinetic energy: how far the energy was off at most, and the slope of a line through the means of parts of its last tenth of a million steps, with its standard error [1/s]. */
function trend({ energies, every, kinetic }) {
  const off = errors(energies, kinetic);
  const last = off.slice(-1000);
  const size = Math.floor(last.length / PARTS);
  const means = Array.from({ length: PARTS }, (_, k) => mean(last.slice(k * size, (k + 1) * size)));
  const times = means.map((_, k) => (k + 0.5) * size * every);
  const [t0, m0] = [mean(times), mean(means)];
  const spread = times.reduce((sum, t) => sum + (t - t0) ** 2, 0);
  const slope = times.reduce((sum, t, k) => sum + (t - t0) * (means[k] - m0), 0) / spread;
  const left = means.reduce((sum, value, k) => sum + (value - m0 - slope * (times[k] - t0)) ** 2, 0);
  return { most: Math.max(...off.map(Math.abs)), slope, error: Math.sqrt(left / (PARTS - 2) / spread) };
}

const errors = (energies, scale) => energies.map((energy) => (energy - energies[0]) / scale);
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function longTable(results) {
  const row = (result) => {
    const { id, h, side, steps, about } = result;
    const { most, slope, error } = trend(result);
    const drift = `(${power(slope)} ± ${power(error)})/s`;
    return `| ${id} | ${side} × ${side}, ${about} | ${h * 1000} ms | ${steps.toLocaleString('en')} | ${sizeOf(most)} | ${drift} | ${claim(result)} |`;
  };
  return [
    '## For long',
    '',
    `At c = ${LONG} m/s. *Off at most*: |ΔE| over the largest kinetic energy, in all steps. *Trend*: the slope of a line through the means of ${PARTS} parts of the last ${LONG_STEPS.toLocaleString('en')} steps, with its standard error; within three of these there is none.`,
    '',
    `Let go *at rest*, a cloth moves slowly at first, and its motion spreads to ever faster swings. What energy a splitting errs by is a function of where things are and how they go, and so it follows that, until all swings have their share: it settles. Without that, and without a trend,`,
    `a cloth is that was *shaken*, each point thrown by up to ${SHAKEN} m/s along each axis, and then left alone for ${(SETTLING * LONG_STEPS).toLocaleString('en')} steps.`,
    '',
    '| method | cloth | h | steps | off at most | trend | |',
    '|---|---|---|---|---|---|---|',
    ...longOnes(results).map(row),
    '',
    '![Energy over time, for long](pictures/energy-long.svg)',
    '',
  ].join('\n');
}

/** The documents' words of their runs, and what the same come to here. */
function toldTable(results) {
  const rows = TOLD.map(([id, c, h, words]) => {
    const cells = TOLD_SIDES.map((side) => {
      const ran = (each) => each.kind === 'told' && each.id === id && each.c === c && each.h === h;
      return verdict(
        results.find((each) => ran(each) && each.side === side),
        scaleOf(results, c),
      );
    });
    return `| ${id} | ${Number.isFinite(c) ? c : '∞'} | ${h * 1000} ms | ${words} | ${cells.join(' | ')} |`;
  });
  return [
    '## The runs that the documents name',
    '',
    `They tell neither how many points their cloth has nor for how long they look. Here it is let go for ${TOLD_TIME} s, without damping; one of 20 × 20 points swings twice as fast, so that h = 1 ms is beyond what explicit methods can take.`,
    'Semi-implicit steps come to what they tell, where the cloth is fine enough, or the time long. Two things do not come about here: steps of 0.1 ms do not explode by the tangent, though it keeps the energy no better than none; and implicit steps, of their equation as it stands, fade at c = 10 m/s whatever the correction but the tangent, and explode at 1 m/s with the secant too.',
    '',
    `| method | c [m/s] | h | the documents | ${TOLD_SIDES.map((side) => `${side} × ${side}`).join(' | ')} |`,
    `|${'---|'.repeat(TOLD_SIDES.length + 4)}`,
    ...rows,
    '',
  ].join('\n');
}

/** By how much the energy rose above its lowest until each time, over the kinetic energy: where air only takes, that comes from nowhere. */
function rises({ energies }, scale) {
  let lowest = Number.POSITIVE_INFINITY;
  return energies.map((energy) => {
    lowest = Math.min(lowest, energy);
    return (energy - lowest) / scale;
  });
}

/** What became of the runs with the documents' damping: those that gained energy. */
function dampedRuns(results) {
  const damped = results.filter(({ kind }) => kind === 'damped');
  const told = damped.flatMap((result) => {
    const { id, c, h, every, stop } = result;
    const rise = rises(result, scaleOf(results, c));
    const out = rise.findIndex((value) => value > 1);
    const most = Math.max(...rise);
    const where = `- ${id}, c = ${c} m/s, h = ${h * 1000} ms:`;
    if (out >= 0) return `${where} **explodes** at ${(out * every).toFixed(2)} s`;
    if (stop) return `${where} **${WHY[stop.reason]}** at ${stop.t.toFixed(2)} s`;
    return most > LEAST_GAIN ? `${where} gains ${sizeOf(most)}` : [];
  });
  const drags = STEPS.map((h) => `${(-Math.log(DAMPING) / h).toPrecision(2)}/s (h = ${h * 1000} ms)`).join(', ');
  return [
    '## With the documents’ damping',
    '',
    `Their programs take a two-hundredth of all velocities away in every step (\`damping\` ${DAMPING}). What is lost in a second then depends on the step: as dp/dt = −drag · p it is a drag of ${drags}.`,
    `So much hides what a method does. Energy can only fall then; of ${damped.length} runs by the documents’ methods at c = ${SPEEDS.filter(Number.isFinite).join(', ')} m/s with these steps, ${told.length} gained more than ${power(LEAST_GAIN)} of the kinetic energy within ${TIME} s${told.length > 0 ? ':' : '.'}`,
    ...(told.length > 0 ? ['', ...told] : []),
    '',
  ].join('\n');
}

const longOnes = (results) =>
  results
    .filter(({ kind }) => kind === 'long')
    .sort((a, b) => a.about.localeCompare(b.about) || SWINGING.indexOf(a.id) - SWINGING.indexOf(b.id));

function claim(result) {
  const { most, slope, error } = trend(result);
  if (result.id === EXACT) return most <= 1e-9 ? 'kept to 10⁻⁹' : '**not kept**';
  if (result.about === 'at rest') return 'settles';
  return Math.abs(slope) < 3 * error ? 'no trend' : '**a trend**';
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
    const { t, word } = fate(result, scale);
    const shown = t === undefined ? result.energies : result.energies.slice(0, Math.ceil(t / result.every) + 1);
    const end = t === undefined ? undefined : `${word}, ${t.toFixed(2)} s`;
    return { name: id, off: errors(shown, scale), every: result.every, end };
  });
  return drawn(curves, `Energy error ΔE over the largest kinetic energy: ${lightOf(c)}, h = ${h * 1000} ms`, TIME);
}

/** Of the splitting that errs most, as all came to settle, and after. */
function longPlot(results) {
  const curves = longOnes(results)
    .filter(({ id }) => id === SWINGING[0])
    .map(({ id, side, about, energies, kinetic, every }) => {
      const name = `${id}, ${about}`;
      return { name, off: errors(energies, kinetic), every, end: `${side} × ${side} points` };
    });
  const time = Math.max(...curves.map(({ off, every }) => (off.length - 1) * every));
  return drawn(curves, `Energy error ΔE over the largest kinetic energy, for long: c = ${LONG} m/s`, time);
}

/** A round number of the size of what is shown, for a mark on the axis. */
function roundMark(most) {
  const size = 10 ** Math.floor(Math.log10(most));
  return size * ([5, 2, 1].find((each) => each * size <= most) ?? 1);
}

/** Curves over time; what is beyond the largest possible error, 1.2, goes along the border. */
function drawn(curves, title, time) {
  const most = Math.min(1.2, 1.15 * Math.max(...curves.flatMap(({ off }) => off.map(Math.abs))));
  const mark = roundMark(most);
  const x = (t) => LEFT + (t / time) * (WIDTH - LEFT - LEGEND);
  const y = (off) => TOP + ((most - Math.max(-most, Math.min(most, off))) / (2 * most)) * (HEIGHT - TOP - FOOT);
  const text = (at, down, words, more = '') => `<text x="${at}" y="${down}" ${more}>${words}</text>`;
  const name = (off) => (off === 0 || mark >= 1e-2 ? String(Number(off.toPrecision(3))).replace('-', '−') : power(off));
  const rules = [-mark, -mark / 2, 0, mark / 2, mark].map(
    (off) =>
      `<line x1="${x(0)}" x2="${x(time)}" y1="${y(off)}" y2="${y(off)}" stroke="#ccc"/>${text(x(0) - 8, y(off) + 4, name(off), 'text-anchor="end"')}`,
  );
  const times = [0, 0.25, 0.5, 0.75, 1].map((share) =>
    text(x(share * time), HEIGHT - FOOT + 18, Number((share * time).toPrecision(3)), 'text-anchor="middle"'),
  );
  const lines = curves.map((curve, i) => {
    const style = `stroke="${COLORS[i]}" stroke-width="2"${i % 2 ? ' stroke-dasharray="7 5"' : ''}`;
    const points = curve.off.map((value, k) => `${x(k * curve.every).toFixed(1)},${y(value).toFixed(1)}`);
    const [across, up] = points.at(-1).split(',');
    const stop = curve.every * (curve.off.length - 1) < 0.99 * time;
    const down = TOP + 12 + 34 * i;
    const at = WIDTH - LEGEND + 16;
    return [
      `<polyline points="${points.join(' ')}" fill="none" ${style}/>`,
      stop ? `<circle cx="${across}" cy="${up}" r="3.5" fill="${COLORS[i]}"/>` : '',
      `<line x1="${at}" x2="${at + 26}" y1="${down - 4}" y2="${down - 4}" ${style}/>`,
      text(at + 32, down, curve.name),
      curve.end ? text(at + 32, down + 14, curve.end, 'fill="#555" font-size="11"') : '',
    ].join('');
  });
  const axis = text(x(time / 2), HEIGHT - 8, 'time [s]', 'text-anchor="middle"');
  const head = text(LEFT, 18, title, 'font-weight="bold"');
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" font-family="sans-serif" font-size="12"><title>${title}</title><rect width="100%" height="100%" fill="#fff"/>${head}${axis}${rules.join('')}${times.join('')}${lines.join('')}</svg>\n`;
}

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib');
  const share = Number(process.argv[2] ?? 1);
  const { METHODS } = await import('../dist/lib/dynamics/index.js');
  const ids = [...METHODS.keys()];
  const results = [
    ...(await studied(await orders(ids, share), availableParallelism())),
    ...(await studied(timings(ids), 1)),
  ];
  const page = written(results);
  if (share === 1) {
    writeFileSync(join(root, 'docs/dynamics.md'), page);
    for (const c of SPEEDS) writeFileSync(join(root, 'docs', pictureOf(c)), plot(results, c));
    writeFileSync(join(root, 'docs/pictures/energy-long.svg'), longPlot(results));
  } else console.log(page);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run dynamics: ${error.message}`);
  process.exit(1);
}
