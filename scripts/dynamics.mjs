// `npm run dynamics`: runs the source documents' hanging cloth by all methods and writes docs/dynamics.md anew, with its plots. Takes some twenty minutes;
// `npm run dynamics -- 0.2` follows a fifth of the time, to see that it works, and writes nothing.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { checkNode, ensureBuilt, ensureModules, root, SetupError } from './setup.mjs';

/** Points along a side, time [s], speeds of light [m/s], steps [s]. */
const N = 10;
const TIME = 2;
const SPEEDS = [1, 10, 100];
const STEPS = [1e-3, 5e-4, 1e-4];
/** The energy is looked at so often [s]. */
const EVERY = 0.01;
/** Of the sources: springs [N/m], weight [m/s²]. */
const [STIFFNESS, GRAVITY] = [1000, [0, -9.8, 0]];

const WHY = { light: 'passes c', indefinite: 'matrix gives out', unsolved: 'not solved', infinite: 'explodes' };

const ABOUT = `# A cloth by all methods

The source documents' cloth: ${N} × ${N} points, a metre and a kilogram, springs of ${STIFFNESS} N/m along edges, across faces and to the next neighbour, weight 9.8 m/s², without damping.
It hangs at two corners and is let go level, for ${TIME} s. Made by \`npm run dynamics\`.

Of each run the table tells how far the energy went from what it was at the start, over the cloth's largest kinetic energy: at most, and what became of it. *Passes c*: a point was given the speed of light or more.
The numbers behind the methods of the sources are their corrections of the energy: 0 none, 1 by the tangent, 2 by the secant, 3 by the root between them.
`;

try {
  checkNode();
  ensureModules();
  ensureBuilt('lib');
  const share = Number(process.argv[2] ?? 1);
  const study = await import('../dist/lib/dynamics/index.js');
  const results = studied(study, TIME * share);
  const page = written(results);
  if (share === 1) {
    writeFileSync(join(root, 'docs/dynamics.md'), page);
    for (const c of SPEEDS) writeFileSync(join(root, `docs/pictures/energy-${c}.svg`), plot(results, c));
  } else console.log(page);
} catch (error) {
  if (!(error instanceof SetupError)) throw error;
  console.error(`\nnpm run dynamics: ${error.message}`);
  process.exit(1);
}

/** A square cloth of a metre and a kilogram, level, held at two corners. */
function cloth({ makeSystem, meshSprings, restingAt, springs, uniform }, c) {
  const x = new Float64Array(3 * N * N);
  const corners = [];
  for (let i = 0; i < N; i++)
    for (let j = 0; j < N; j++) {
      x.set([j / (N - 1), 0, i / (N - 1)], 3 * (i * N + j));
      if (i + 1 < N && j + 1 < N) corners.push(i * N + j, i * N + j + 1, (i + 1) * N + j + 1, (i + 1) * N + j);
    }
  const masses = new Float64Array(N * N).fill(1 / (N * N));
  const pinned = new Uint8Array(N * N);
  pinned[0] = pinned[N - 1] = 1;
  const faces = { counts: new Array((N - 1) ** 2).fill(4), corners };
  const net = springs(meshSprings(x, faces, { structural: STIFFNESS, shear: STIFFNESS, bending: STIFFNESS }));
  const system = makeSystem({ masses, pinned, c, forces: [net, uniform(masses, GRAVITY)] });
  return { system, start: restingAt(x) };
}

/** Of each method, speed of light and step: how far the energy went, where it stopped, what it cost. */
function studied(study, time) {
  const results = [];
  for (const c of SPEEDS)
    for (const method of study.METHODS.values())
      for (const h of STEPS) {
        process.stderr.write(`\r${method.id}, c = ${c} m/s, h = ${h} s        `);
        results.push({ id: method.id, c, h, ...followed(study, method, c, h, time) });
      }
  process.stderr.write('\n');
  return results;
}

function followed(study, method, c, h, time) {
  const began = performance.now();
  const energies = [];
  const running = study.run({ ...cloth(study, c), method, duration: time, every: EVERY, step: h });
  let [kinetic, steps] = [0, 0];
  for (;;) {
    const { done, value } = running.next();
    if (done) return { energies, kinetic, stop: value, ms: (performance.now() - began) / Math.max(1, steps) };
    energies.push(value.ledger.total);
    kinetic = Math.max(kinetic, value.ledger.kinetic);
    steps = value.steps;
  }
}

/** The largest kinetic energy of the cloth, which errors are measured by: by the method that keeps the energy, at its shortest step [J]. */
function scaleOf(results, c) {
  return results.find(
    (result) => result.id === 'discrete-gradient' && result.c === c && result.h === Math.min(...STEPS),
  ).kinetic;
}

function verdict({ energies, stop }, scale) {
  if (stop) return `**${WHY[stop.reason]}** at ${stop.t.toFixed(2)} s`;
  const off = energies.map((energy) => (energy - energies[0]) / scale);
  const most = Math.max(...off.map(Math.abs));
  const end = off.at(-1);
  const size = most < 1e-3 ? most.toExponential(0) : `${(100 * most).toPrecision(2)} %`;
  if (most > 1) return `**explodes**, ${size}`;
  if (end < -0.05) return `fades, ${size}`;
  return end > 0.05 ? `grows, ${size}` : size;
}

function written(results) {
  const tables = SPEEDS.map((c) => {
    const rows = [...new Set(results.map(({ id }) => id))].map((id) => {
      const cells = STEPS.map((h) => {
        const result = results.find((each) => each.id === id && each.c === c && each.h === h);
        return verdict(result, scaleOf(results, c));
      });
      const { ms } = results.find((each) => each.id === id && each.c === c && each.h === Math.min(...STEPS));
      return `| ${id} | ${cells.join(' | ')} | ${ms.toPrecision(2)} |`;
    });
    const head = `| method | ${STEPS.map((h) => `h = ${h * 1000} ms`).join(' | ')} | ms a step |`;
    const plotted = `![Energy over time](pictures/energy-${c}.svg)`;
    return [`## c = ${c} m/s`, '', head, `|${'---|'.repeat(STEPS.length + 2)}`, ...rows, '', plotted, ''].join('\n');
  });
  return `${ABOUT}\n${tables.join('\n')}`;
}

/** The energy over time of a method of each kind, at the longest step. */
function plot(results, c) {
  const shown = [
    'semi-implicit-euler-0',
    'semi-implicit-euler-2',
    'linearly-implicit-0',
    'linearly-implicit-2',
    'leapfrog',
    'discrete-gradient',
  ];
  const colors = ['#c44', '#e90', '#84c', '#39c', '#2a6', '#222'];
  const h = Math.max(...STEPS);
  const scale = scaleOf(results, c);
  const [width, height, left, top] = [760, 300, 60, 20];
  const place = (t, off) => {
    const y = Math.max(-1.2, Math.min(1.2, off));
    return `${(left + (t / TIME) * (width - left - 190)).toFixed(1)},${(top + ((1.2 - y) / 2.4) * (height - top - 40)).toFixed(1)}`;
  };
  const line = (from, to, style) => {
    const [[x1, y1], [x2, y2]] = [from.split(','), to.split(',')];
    return `<line x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}" ${style}/>`;
  };
  const parts = shown.map((id, i) => {
    const { energies } = results.find((each) => each.id === id && each.c === c && each.h === h);
    const points = energies.map((energy, k) => place(k * EVERY, (energy - energies[0]) / scale)).join(' ');
    const y = top + 14 + 18 * i;
    return `<polyline points="${points}" fill="none" stroke="${colors[i]}" stroke-width="1.6"/><line x1="${width - 175}" y1="${y - 4}" x2="${width - 155}" y2="${y - 4}" stroke="${colors[i]}" stroke-width="2"/><text x="${width - 150}" y="${y}">${id}</text>`;
  });
  const marks = [-1, 0, 1].map((off) => {
    const [x, y] = place(0, off).split(',');
    return `${line(place(0, off), place(TIME, off), 'stroke="#ccc"')}<text x="${x - 8}" y="${Number(y) + 4}" text-anchor="end">${off}</text>`;
  });
  const [, foot] = place(0, -1.2).split(',');
  const times = [0, TIME / 2, TIME].map(
    (t) => `<text x="${place(t, 0).split(',')[0]}" y="${Number(foot) + 18}" text-anchor="middle">${t} s</text>`,
  );
  const title = `<text x="${left}" y="${top - 6}">(E − E₀)/T, c = ${c} m/s, h = ${h * 1000} ms</text>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="#fff"/>${title}${marks.join('')}${times.join('')}${parts.join('')}</svg>\n`;
}
