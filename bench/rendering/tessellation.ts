import { fileURLToPath } from 'node:url';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { createTracedScene } from '../../src/reference/intersection/tracedScene.ts';
import type { SceneRenderer } from '../../src/render/renderer.ts';
import type { Scene } from '../../src/scene/types.ts';
import { type ExampleName, NAMES, speedOfLight } from '../../tests/examples/open.ts';
import { type ErrorTally, tallyErrors } from '../../tests/visual/errorTally.ts';
import { exampleFrame, type TestView } from '../../tests/visual/frames.ts';
import { MAX_DISPLACEMENT, PixelOracle } from '../../tests/visual/pixelOracle.ts';
import { readSamplePixels, somePixels } from '../../tests/visual/pixels.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu } from '../support/gpu.ts';
import { tessellationTimes } from './tessellationTime.ts';
import { longestEdge, subdivideUniformly } from './uniformSubdivision.ts';

const SIZE = { width: 1280, height: 720 };
const PIXELS = somePixels(SIZE, 4000, 20_261_121);
const BETAS = [0.9, 0.99];
const ROUNDS = 5;
/** Maximum number of triangles of uniform subdivision. */
const MAX_TRIANGLES = 2_000_000;
/** Fraction of pixels that may be wrong, the goal of subdivision. */
const WRONG = 1e-3;
/** A tolerance [px]. */
const UNCUT = Number.POSITIVE_INFINITY;

export const tessellation: Bench = {
  name: 'tessellation',
  title: 'Edges cut as each picture needs it, cut alike, and uncut',
  about:
    `The examples from their cameras at ${SIZE.width} × ${SIZE.height}, on WebGPU. *Uncut*: the triangles of the scene. *As needed*: what the program does. *Alike*: no edge longer than the greatest length, of halvings of the ` +
    `scene's longest one, with which the picture is as right as the program's, or has at most ${100 * WRONG} % wrong pixels and none more than ${MAX_DISPLACEMENT} px beside its place; at most ${MAX_TRIANGLES.toLocaleString('en')} triangles. ` +
    `Wrong, and the most that what a pixel shows is beside its place: ${PIXELS.length.toLocaleString('en')} pixels against rays of the reference, as in tests/visual. A frame ends when the GPU has answered; all three take turns. ` +
    "*Plan*: a processor's part of it, in f64, which in the page is a worker's; *with levels*: and what the GPU has left to do on WebGPU, but not on WebGL2.",
  async run() {
    const errors: (string | number)[][] = [];
    const costs: (string | number)[][] = [];
    for (const name of NAMES) {
      const scene = await openSceneFile(fileURLToPath(new URL(`../../../../examples/${name}.usdc`, import.meta.url)));
      for (const beta of BETAS) {
        const { error, cost } = await rowsOf(name, scene, beta);
        errors.push(error);
        costs.push(cost);
      }
    }
    const { adapterName } = await gpu();
    const kinds = ['uncut', 'as needed', 'alike'];
    const columns = [...kinds.map((kind) => `${kind}: wrong [%]`), ...kinds.map((kind) => `${kind}: worst [px]`)];
    return [
      { columns: ['scene', 'β', ...columns, 'alike: longest edge [m]'], rows: errors },
      {
        columns: [
          ...['scene', 'β', ...kinds.map((kind) => `${kind}: triangles`), ...kinds.map((kind) => `${kind} [ms]`)],
          ...['as needed ÷ uncut', '÷ alike', 'plan [ms]', 'with levels [ms]'],
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
  const judge = new PixelOracle({ scene: createTracedScene(scene, speedOfLight(scene)), ...frame, ...SIZE });
  const planning = await tessellationTimes(scene, frame, SIZE);
  const uncut = await openTable(frame, scene, UNCUT);
  const needed = await openTable(frame, scene);
  const alike = await openTable(frame, scene, UNCUT);
  const [before, after] = [await uncut.judged(judge), await needed.judged(judge)];
  const { longest, tally, enough } = await layAlike(alike, scene, judge, after, before);
  // Collects the garbage of subdivision now instead of during a measured frame.
  globalThis.gc?.();
  const ms = await interleaved([uncut.draw, needed.draw, alike.draw], ROUNDS);
  const tables = [uncut, needed, alike];
  const [few, some, many] = tables.map(({ renderer }) => renderer.info.triangles.toLocaleString('en'));
  for (const { renderer } of tables) renderer.dispose();
  const tallies = [before, after, tally];
  const errors = [...tallies.map(({ wrong }) => 100 * wrong), ...tallies.map((t) => t.displacement.worst)];
  const counts = [few, some, enough ? many : `> ${many}`];
  return {
    error: [name, beta, ...errors, longest],
    cost: [name, beta, ...counts, ...ms, ms[1] / ms[0], ms[1] / ms[2], ...planning],
  };
}

/** A renderer for one frame. */
interface Table {
  readonly renderer: SceneRenderer;
  draw(): Promise<void>;
  judged(judge: PixelOracle): Promise<ErrorTally>;
}

async function openTable({ view, settings }: TestView, scene: Scene, tolerance?: number): Promise<Table> {
  const { device } = await gpu();
  const { SceneRenderer } = await import('../../src/render/renderer.ts');
  const renderer = await SceneRenderer.create({ device, backend: 'webgpu', ...(tolerance && { tolerance }) });
  renderer.setSize(SIZE.width, SIZE.height);
  await renderer.setScene(scene);
  return {
    renderer,
    draw: async () => {
      pumpFrame();
      renderer.render([view], settings);
      await renderer.pick(0, 0);
    },
    judged: async (judge) => {
      pumpFrame();
      const values = await readSamplePixels(renderer, { view, settings, ...SIZE, pixels: PIXELS });
      // Counts the triangles.
      await renderer.readPixels();
      return tallyErrors(judge, values, PIXELS);
    },
  };
}

/** Subdivides uniformly until the picture is as correct as `goal`, or the maximum is reached. Far from the goal, errors decrease with the square of edge lengths. */
async function layAlike(
  { renderer, judged }: Table,
  scene: Scene,
  judge: PixelOracle,
  goal: ErrorTally,
  uncut: ErrorTally,
) {
  const whole = longestEdge(scene);
  let best = { longest: whole, tally: uncut, enough: isAsRight(uncut, goal) };
  while (!best.enough) {
    const longest = best.longest / (best.tally.displacement.worst > 32 * MAX_DISPLACEMENT ? 4 : 2);
    const finer = subdivideUniformly(scene, longest, MAX_TRIANGLES);
    if (!finer) break;
    await renderer.setScene(finer);
    const tally = await judged(judge);
    best = { longest, tally, enough: isAsRight(tally, goal) };
  }
  return best;
}

const isAsRight = (tally: ErrorTally, goal: ErrorTally): boolean =>
  tally.wrong <= Math.max(goal.wrong, WRONG) &&
  tally.displacement.worst <= Math.max(goal.displacement.worst, MAX_DISPLACEMENT);
