// `npm run dynamics`: runs the source documents' hanging cloth by all methods and regenerates docs/dynamics.md with its plots. Takes some minutes on all cores;
// `npm run dynamics -- 0.1` simulates a tenth of the time, as a test, and writes nothing.
import { writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { checkNode, ensureBuilt, ensureModules, root, SetupError } from './setup.mjs';

/** Points along a side; stiffness [N/m] and gravity [m/s²] as in the source documents. */
const SIDE = 10;
const CLOTH = { stiffness: 1000, gravity: [0, -9.8, 0] };
/** Time [s], speeds of light [m/s], steps [s]. */
const TIME = 2;
const SPEEDS = [1, 10, 100, Number.POSITIVE_INFINITY];
const STEPS = [1e-3, 5e-4, 1e-4];
/** Interval between energy samples [s]. */
const EVERY = 0.01;
/** The documents' runs: method, c [m/s], h [s] and their description. Duration [s] and points along a side are not documented; those used here follow. */
const DOCUMENTED = [
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
const DOCUMENTED_TIME = 5;
const DOCUMENTED_SIDES = [10, 20];
/** Factor that the documents' programs apply to all velocities in every step, and the methods that they used it with. */
const DAMPING = 0.995;
const DAMPED = /^(semi-implicit-euler|linearly-implicit)-/;
/** Energy gains below this fraction of the kinetic energy are rounding. */
const MIN_GAIN = 1e-6;
/** Timing of each method, after all other runs: simulated time [s], short enough that none ends early; number of parts; repetitions. */
const [TIMED, TIMED_PARTS, TIMED_OFTEN] = [0.6, 30, 3];
/** Long runs: c [m/s] and number of steps. */
const LONG = 10;
const LONG_STEPS = 100_000;
/** The method that conserves energy to 10⁻⁹, with its step [s]; the cloth starts at rest. */
const EXACT = 'discrete-gradient';
const EXACT_STEP = 1e-3;
/** Methods whose energy error oscillates without a trend: step [s], side of a smaller cloth, initial velocities [m/s] that excite all modes, and settling time relative to the measured time. */
const SWINGING = ['leapfrog', 'yoshida-4', 'yoshida-6', 'yoshida-8', 'implicit-midpoint'];
const [SWINGING_STEP, SWINGING_SIDE, SHAKEN, SETTLING] = [5e-4, 5, 3, 4];
/** Number of parts of a long run; the trend is fitted to their means. */
const PARTS = 25;

const WHY = {
  light: 'passes c',
  indefinite: 'matrix gives out',
  unsolved: 'not solved',
  infinite: 'explodes',
  unstable: 'explodes',
};

const ABOUT = `# A cloth by all methods

The [source documents'](physics.md#14-the-source-documents) cloth: ${SIDE} × ${SIDE} points, a metre and a kilogram, springs of ${CLOTH.stiffness} N/m along edges, across faces and to the next neighbour, weight 9.8 m/s², without damping.
It is released horizontally, held at two corners, and simulated for ${TIME} s. Its fastest oscillation has ω = 1550/s, so that h = 1 ms is three quarters of the stability limit of an explicit method. Made by \`npm run dynamics\`.

Each cell gives the largest deviation of the energy from its initial value, relative to the largest kinetic energy of the accurate solution (${EXACT}, h = ${STEPS.at(-1) * 1000} ms), and the outcome.
*Explodes*: the deviation exceeds that kinetic energy; *passes c*: a point reached the speed of light or more; *matrix gives out*: the matrix is no longer positive definite; *fades* and *grows*: more than a twentieth was lost or gained at the end.
The numbers after the methods of the sources are their energy corrections: 0 none, 1 by the tangent, 2 by the secant, 3 by the root (all momenta times the factor that conserves the energy). The last column is the time to compute a step of ${STEPS.at(-1) * 1000} ms when nothing else runs: the median of ${TIMED_PARTS} parts of ${TIMED} s of motion, each the fastest of ${TIMED_OFTEN} times.
`;

/** All runs, the longest first, so that all cores finish at about the same time; `fraction` of the full durations. */
async function allRuns(ids, fraction) {
  const short = ids.flatMap((id) =>
    SPEEDS.flatMap((c) => STEPS.map((h) => ({ id, c, h, side: SIDE, every: EVERY, duration: TIME * fraction }))),
  );
  const damped = short
    .filter(({ id, c }) => DAMPED.test(id) && Number.isFinite(c))
    .map((options) => ({ ...options, drag: -Math.log(DAMPING) / options.h, kind: 'damped' }));
  const documented = DOCUMENTED.flatMap(([id, c, h]) =>
    DOCUMENTED_SIDES.map((side) => ({
      ...{ id, c, h, side },
      ...{ every: EVERY, duration: DOCUMENTED_TIME * fraction, kind: 'documented' },
    })),
  );
  const lasting = (id, h, times) => {
    const measured = LONG_STEPS * h * fraction;
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
  return [...long, ...short, ...damped, ...documented].sort((a, b) => weight(b) - weight(a));
}

/** Timing runs, to be executed one after the other when nothing else runs; each several times. */
const timings = (ids) =>
  Array.from({ length: TIMED_OFTEN }, () => ids).flatMap((round) =>
    round.flatMap((id) =>
      SPEEDS.map((c) => ({
        ...{ id, c, h: STEPS.at(-1), side: SIDE },
        ...{ every: TIMED / TIMED_PARTS, duration: TIMED, kind: 'timed' },
      })),
    ),
  );

/** Time per step [ms]: the median over the parts, of the fastest repetition of each. */
function costOf(results, id, c) {
  const [first, ...others] = results.filter((each) => each.kind === 'timed' && each.id === id && each.c === c);
  const quickest = first.costs.map((cost, k) => Math.min(cost, ...others.map(({ costs }) => costs[k])));
  return quickest.sort((a, b) => a - b)[Math.floor(quickest.length / 2)];
}

/** Runs a queue in worker threads. */
async function studied(queue, threads) {
  const all = queue.length;
  const results = [];
  const next = queue.values();
  const thread = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL('./dynamicsCase.mjs', import.meta.url), { workerData: CLOTH });
      let current;
      worker.on('error', reject);
      worker.on('message', (result) => {
        if (result) results.push({ ...result, side: current.side, kind: current.kind, about: current.about });
        process.stderr.write(`\r${results.length} of ${all} runs `);
        current = next.next().value;
        if (current) worker.postMessage(current);
        else worker.terminate().then(resolve, reject);
      });
    });
  await Promise.all(Array.from({ length: threads }, thread));
  process.stderr.write('\n');
  return results;
}

const find = (results, id, c, h, kind) =>
  results.find((each) => each.kind === kind && each.id === id && each.c === c && each.h === h);

/** Scale of the errors: the largest kinetic energy of the cloth, by the energy-conserving method with the shortest step [J]. */
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

/** The outcome of a run's energy in a word, and its largest error. */
function fate({ energies, every, stop }, scale) {
  const deviation = errors(energies, scale);
  const most = Math.max(...deviation.map(Math.abs));
  const out = deviation.findIndex((value) => Math.abs(value) > 1);
  if (out >= 0) return { word: 'explodes', most, t: out * every };
  if (stop) return { word: WHY[stop.reason] ?? stop.reason, most, t: stop.t };
  if (deviation.at(-1) < -0.05) return { word: 'fades', most };
  return { word: deviation.at(-1) > 0.05 ? 'grows' : '', most };
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
  return [ABOUT, summary(results), ...tables, documentedTable(results), dampedRuns(results), longTable(results)].join(
    '\n',
  );
}

/** Number of runs by outcome, for each kind of method. */
function summary(results) {
  const line = (kind, who) => {
    const fates = results
      .filter((result) => result.kind === undefined && kindOf(result.id) === kind)
      .map((result) => fate(result, scaleOf(results, result.c)));
    const count = (test) => fates.filter(test).length;
    const kept = count(({ word, most }) => !word && most < 0.01);
    const ends = count(({ t }) => t !== undefined);
    const [fade, grow] = ['fades', 'grows'].map((name) => count(({ word }) => word === name));
    return `- ${who}: of ${fates.length} runs ${ends} end early (they explode, pass c, or their matrix gives out), ${fade} fade, ${grow} grow; ${kept} conserve the energy to a hundredth.`;
  };
  return ['## In short', '', line('sources', 'The methods of the sources'), line('ours', 'Ours'), ''].join('\n');
}

/** Of a long run, relative to the kinetic energy: the largest energy error, and the slope of a line through the means of parts of the last 100,000 steps, with its standard error [1/s]. */
function trend({ energies, every, kinetic }) {
  const deviation = errors(energies, kinetic);
  const last = deviation.slice(-1000);
  const size = Math.floor(last.length / PARTS);
  const means = Array.from({ length: PARTS }, (_, k) => mean(last.slice(k * size, (k + 1) * size)));
  const times = means.map((_, k) => (k + 0.5) * size * every);
  const [t0, m0] = [mean(times), mean(means)];
  const spread = times.reduce((sum, t) => sum + (t - t0) ** 2, 0);
  const slope = times.reduce((sum, t, k) => sum + (t - t0) * (means[k] - m0), 0) / spread;
  const left = means.reduce((sum, value, k) => sum + (value - m0 - slope * (times[k] - t0)) ** 2, 0);
  return { most: Math.max(...deviation.map(Math.abs)), slope, error: Math.sqrt(left / (PARTS - 2) / spread) };
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
    `At c = ${LONG} m/s. *Off at most*: the largest |ΔE| of all steps, relative to the largest kinetic energy. *Trend*: the slope of a line through the means of ${PARTS} parts of the last ${LONG_STEPS.toLocaleString('en')} steps, with its standard error; below three standard errors there is no trend.`,
    '',
    `Released *at rest*, a cloth moves slowly at first, and its motion spreads to ever faster oscillations. The energy error of a splitting method is a function of positions and velocities, so it follows that spreading until all oscillations are excited: it settles. Neither settling nor a trend is shown by`,
    `a cloth that was *shaken*: each point starts with up to ${SHAKEN} m/s along each axis, and the cloth then runs undisturbed for ${(SETTLING * LONG_STEPS).toLocaleString('en')} steps.`,
    '',
    '| method | cloth | h | steps | off at most | trend | |',
    '|---|---|---|---|---|---|---|',
    ...longOnes(results).map(row),
    '',
    '![Energy over time, for long](pictures/energy-long.svg)',
    '',
  ].join('\n');
}

/** The documents' descriptions of their runs, and the results here. */
function documentedTable(results) {
  const rows = DOCUMENTED.map(([id, c, h, words]) => {
    const cells = DOCUMENTED_SIDES.map((side) => {
      const ran = (each) => each.kind === 'documented' && each.id === id && each.c === c && each.h === h;
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
    `They give neither the number of points of their cloth nor the duration. Here it is simulated for ${DOCUMENTED_TIME} s, without damping; one of 20 × 20 points oscillates twice as fast, so that h = 1 ms is beyond the stability limit of explicit methods.`,
    'Semi-implicit steps reproduce their descriptions if the cloth is fine enough or the time long enough. Two descriptions are not reproduced here: steps of 0.1 ms do not explode by the tangent, though it keeps the energy no better than none; and implicit steps, of their equation as it stands, fade at c = 10 m/s whatever the correction but the tangent, and explode at 1 m/s with the secant too.',
    '',
    `| method | c [m/s] | h | the documents | ${DOCUMENTED_SIDES.map((side) => `${side} × ${side}`).join(' | ')} |`,
    `|${'---|'.repeat(DOCUMENTED_SIDES.length + 4)}`,
    ...rows,
    '',
  ].join('\n');
}

/** Rise of the energy above its running minimum, over the kinetic energy: with damping alone it can only fall. */
function rises({ energies }, scale) {
  let lowest = Number.POSITIVE_INFINITY;
  return energies.map((energy) => {
    lowest = Math.min(lowest, energy);
    return (energy - lowest) / scale;
  });
}

/** Runs with the documents' damping that gained energy. */
function dampedRuns(results) {
  const damped = results.filter(({ kind }) => kind === 'damped');
  const gains = damped.flatMap((result) => {
    const { id, c, h, every, stop } = result;
    const rise = rises(result, scaleOf(results, c));
    const out = rise.findIndex((value) => value > 1);
    const most = Math.max(...rise);
    const where = `- ${id}, c = ${c} m/s, h = ${h * 1000} ms:`;
    if (out >= 0) return `${where} **explodes** at ${(out * every).toFixed(2)} s`;
    if (stop) return `${where} **${WHY[stop.reason]}** at ${stop.t.toFixed(2)} s`;
    return most > MIN_GAIN ? `${where} gains ${sizeOf(most)}` : [];
  });
  const drags = STEPS.map((h) => `${(-Math.log(DAMPING) / h).toPrecision(2)}/s (h = ${h * 1000} ms)`).join(', ');
  return [
    '## With the documents’ damping',
    '',
    `The documents name a \`damping\` of ${DAMPING}. As a factor on all velocities in every step, its loss per second depends on the step: as dp/dt = −drag · p it corresponds to a drag of ${drags}.`,
    `Such strong damping hides the behaviour of a method. With it the energy can only decrease; of ${damped.length} runs by the documents’ methods at c = ${SPEEDS.filter(Number.isFinite).join(', ')} m/s with these steps, ${gains.length} gained more than ${power(MIN_GAIN)} of the kinetic energy within ${TIME} s${gains.length > 0 ? ':' : '.'}`,
    ...(gains.length > 0 ? ['', ...gains] : []),
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
/** Okabe and Ito's palette, which is safe for colour-blind readers. */
const COLORS = ['#d55e00', '#e69f00', '#cc79a7', '#56b4e9', '#009e73', '#000000'];

/** Plot of the energy over time of one method of each kind, at the longest step. */
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
    return { name: id, deviation: errors(shown, scale), every: result.every, end };
  });
  return drawn(curves, `Energy error ΔE over the largest kinetic energy: ${lightOf(c)}, h = ${h * 1000} ms`, TIME);
}

/** Plot of the splitting method with the largest error, during and after settling. */
function longPlot(results) {
  const curves = longOnes(results)
    .filter(({ id }) => id === SWINGING[0])
    .map(({ id, side, about, energies, kinetic, every }) => {
      const name = `${id}, ${about}`;
      return { name, deviation: errors(energies, kinetic), every, end: `${side} × ${side} points` };
    });
  const time = Math.max(...curves.map(({ deviation, every }) => (deviation.length - 1) * every));
  return drawn(curves, `Energy error ΔE over the largest kinetic energy, for long: c = ${LONG} m/s`, time);
}

/** A round number near the range, for an axis tick. */
function roundMark(most) {
  const size = 10 ** Math.floor(Math.log10(most));
  return size * ([5, 2, 1].find((each) => each * size <= most) ?? 1);
}

/** Curves over time, clamped to ±1.2. */
function drawn(curves, title, time) {
  const most = Math.min(1.2, 1.15 * Math.max(...curves.flatMap(({ deviation }) => deviation.map(Math.abs))));
  const mark = roundMark(most);
  const x = (t) => LEFT + (t / time) * (WIDTH - LEFT - LEGEND);
  const y = (deviation) =>
    TOP + ((most - Math.max(-most, Math.min(most, deviation))) / (2 * most)) * (HEIGHT - TOP - FOOT);
  const text = (at, down, words, more = '') => `<text x="${at}" y="${down}" ${more}>${words}</text>`;
  const name = (deviation) =>
    deviation === 0 || mark >= 1e-2 ? String(Number(deviation.toPrecision(3))).replace('-', '−') : power(deviation);
  const rules = [-mark, -mark / 2, 0, mark / 2, mark].map(
    (deviation) =>
      `<line x1="${x(0)}" x2="${x(time)}" y1="${y(deviation)}" y2="${y(deviation)}" stroke="#ccc"/>${text(x(0) - 8, y(deviation) + 4, name(deviation), 'text-anchor="end"')}`,
  );
  const times = [0, 0.25, 0.5, 0.75, 1].map((fraction) =>
    text(x(fraction * time), HEIGHT - FOOT + 18, Number((fraction * time).toPrecision(3)), 'text-anchor="middle"'),
  );
  const lines = curves.map((curve, i) => {
    const style = `stroke="${COLORS[i]}" stroke-width="2"${i % 2 ? ' stroke-dasharray="7 5"' : ''}`;
    const points = curve.deviation.map((value, k) => `${x(k * curve.every).toFixed(1)},${y(value).toFixed(1)}`);
    const [across, up] = points.at(-1).split(',');
    const stop = curve.every * (curve.deviation.length - 1) < 0.99 * time;
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
  const fraction = Number(process.argv[2] ?? 1);
  const { METHODS } = await import('../dist/lib/dynamics/index.js');
  const ids = [...METHODS.keys()];
  const results = [
    ...(await studied(await allRuns(ids, fraction), availableParallelism())),
    ...(await studied(timings(ids), 1)),
  ];
  const page = written(results);
  if (fraction === 1) {
    writeFileSync(join(root, 'docs/dynamics.md'), page);
    for (const c of SPEEDS) writeFileSync(join(root, 'docs', pictureOf(c)), plot(results, c));
    writeFileSync(join(root, 'docs/pictures/energy-long.svg'), longPlot(results));
  } else console.log(page);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run dynamics: ${error.message}`);
  process.exit(1);
}
