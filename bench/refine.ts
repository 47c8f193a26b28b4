import { fileURLToPath } from 'node:url';
import { openSceneFile } from '../src/cli/files.ts';
import { pumpFrame } from '../src/cli/node-shim.ts';
import { traceable } from '../src/reference/trace.ts';
import type { SceneRenderer } from '../src/render/renderer.ts';
import type { Scene } from '../src/scene/types.ts';
import { type ExampleName, NAMES, speedOfLight } from '../tests/examples/open.ts';
import { exampleFrame, type Frame } from '../tests/visual/frames.ts';
import { Judge, REACH } from '../tests/visual/judge.ts';
import { somePixels, takePixels } from '../tests/visual/pixels.ts';
import { type Tally, tallyOf } from '../tests/visual/tally.ts';
import { cutAlike, longestEdge } from './alike.ts';
import { type Bench, interleaved, median } from './bench.ts';
import { gpu } from './gpu.ts';

const SIZE = { width: 1280, height: 720 };
const PIXELS = somePixels(SIZE, 4000, 20_261_121);
const BETAS = [0.9, 0.99];
const ROUNDS = 5;
/** What cutting alike may come to. */
const MOST_TRIANGLES = 2_000_000;
/** The goal of cutting: so many pixels may be wrong. */
const WRONG = 1e-3;

export const refine: Bench = {
  name: 'refine',
  title: 'Edges cut for each picture, cut alike, and uncut',
  about:
    `The examples from their cameras at ${SIZE.width} × ${SIZE.height}, on WebGPU. *Uncut*: the triangles of the scene. *For each picture*: what the program does. *Alike*: no edge longer than the greatest length, of halvings of the ` +
    `scene's longest one, with which the picture is as right as the program's, or has at most ${100 * WRONG} % wrong pixels and none more than ${REACH} px beside its place; at most ${MOST_TRIANGLES.toLocaleString('en')} triangles. ` +
    `Wrong, and the most that what a pixel shows is beside its place: ${PIXELS.length.toLocaleString('en')} pixels against rays of the reference, as in tests/visual. A frame ends when the GPU has answered; all three take turns. ` +
    '*Main thread*: until `render` returns, uncut and cut for the picture.',
  async run() {
    const errors: (string | number)[][] = [];
    const costs: (string | number)[][] = [];
    for (const name of NAMES) {
      const scene = await openSceneFile(fileURLToPath(new URL(`../../../examples/${name}.usda`, import.meta.url)));
      for (const beta of BETAS) {
        const { error, cost } = await rowsOf(name, scene, beta);
        errors.push(error);
        costs.push(cost);
      }
    }
    const { adapterName } = await gpu();
    const kinds = ['uncut', 'for each picture', 'alike'];
    const columns = [...kinds.map((kind) => `${kind}: wrong [%]`), ...kinds.map((kind) => `${kind}: worst [px]`)];
    return [
      { columns: ['scene', 'β', ...columns, 'alike: longest edge [m]'], rows: errors },
      {
        columns: [
          ...['scene', 'β', ...kinds.map((kind) => `${kind}: triangles`), ...kinds.map((kind) => `${kind} [ms]`)],
          ...['for each picture ÷ uncut', '÷ alike', 'main thread, uncut [ms]', 'cut [ms]'],
        ],
        rows: costs,
        remark: `On ${adapterName}. *>*: not as right with so many triangles either.`,
      },
    ];
  },
};

type Row = (string | number)[];

async function rowsOf(name: ExampleName, scene: Scene, beta: number): Promise<{ error: Row; cost: Row }> {
  console.error(`  ${name} at ${beta} c`);
  const frame = exampleFrame(name, scene, 'light-cone', beta);
  const judge = new Judge({ scene: traceable(scene, speedOfLight(scene)), ...frame, ...SIZE });
  const [uncut, cut, alike] = [
    await openTable(frame, Number.POSITIVE_INFINITY),
    await openTable(frame),
    await openTable(frame, Number.POSITIVE_INFINITY),
  ];
  await uncut.lay(scene);
  await cut.lay(scene);
  const [before, after] = [await uncut.judged(judge), await cut.judged(judge)];
  const { longest, tally, enough } = await layAlike(alike, scene, judge, after, before);
  const ms = await interleaved([uncut.draw, cut.draw, alike.draw], ROUNDS);
  const tables = [uncut, cut, alike];
  const [few, some, many] = tables.map(({ renderer }) => renderer.info.triangles.toLocaleString('en'));
  const tallies = [before, after, tally];
  const error = [
    ...[name, beta, ...tallies.map(({ wrong }) => 100 * wrong), ...tallies.map((t) => t.displacement.worst)],
    longest,
  ];
  const cost = [
    ...[name, beta, few, some, enough ? many : `> ${many}`, ...ms, ms[1] / ms[0], ms[1] / ms[2]],
    ...[uncut, cut].map(({ busy }) => median(busy.slice(1))),
  ];
  for (const { renderer } of tables) renderer.dispose();
  return { error, cost };
}

/** A renderer for one frame. */
interface Table {
  readonly renderer: SceneRenderer;
  /** Of the main thread, for each picture drawn [ms]. */
  readonly busy: number[];
  lay(scene: Scene): Promise<void>;
  draw(): Promise<void>;
  judged(judge: Judge): Promise<Tally>;
}

async function openTable(frame: Frame, tolerance?: number): Promise<Table> {
  const { device } = await gpu();
  const { SceneRenderer } = await import('../src/render/renderer.ts');
  const renderer = await SceneRenderer.create({ device, backend: 'webgpu', ...(tolerance && { tolerance }) });
  renderer.setSize(SIZE.width, SIZE.height);
  const busy: number[] = [];
  return {
    renderer,
    busy,
    lay: (scene) => renderer.setScene(scene),
    draw: async () => {
      pumpFrame();
      renderer.render(frame.view, frame.settings);
      busy.push(renderer.info.milliseconds);
      await renderer.pick(0, 0);
    },
    judged: async (judge) => {
      pumpFrame();
      const values = await takePixels(renderer, { ...frame, ...SIZE, pixels: PIXELS });
      // Counts the triangles.
      await renderer.readPixels();
      return tallyOf(judge, values, PIXELS);
    },
  };
}

/** Cuts all edges alike until the picture is as right as `goal`, or there is no room. Far from it, errors shrink with the square of lengths. */
async function layAlike(table: Table, scene: Scene, judge: Judge, goal: Tally, uncut: Tally) {
  const whole = longestEdge(scene);
  let best = { longest: whole, tally: uncut, enough: isAsRight(uncut, goal) };
  await table.lay(scene);
  await table.judged(judge);
  for (let longest = whole; !best.enough; ) {
    longest /= best.tally.displacement.worst > 32 * REACH ? 4 : 2;
    const finer = cutAlike(scene, longest, MOST_TRIANGLES);
    if (!finer) return best;
    await table.lay(finer);
    const tally = await table.judged(judge);
    best = { longest, tally, enough: isAsRight(tally, goal) };
  }
  return best;
}

const isAsRight = (tally: Tally, goal: Tally): boolean =>
  tally.wrong <= Math.max(goal.wrong, WRONG) && tally.displacement.worst <= Math.max(goal.displacement.worst, REACH);
