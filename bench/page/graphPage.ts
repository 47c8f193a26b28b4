import type { Page } from 'playwright-core';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { copyFragment, serializeFragment } from '../../src/graph/edits/fragment.ts';
import { type Bench, median, type Table } from '../support/bench.ts';
import { LLVMPIPE, type PageServer, servePage } from './browsers.ts';
import { gridProject } from './gridProject.ts';

const SIZES = [30, 100, 300];
const ROUNDS = 1;
/** Number of mouse moves, forth and back. */
const STEPS = 20;
const PASTED = 2000;
const VIEWPORT = { width: 1440, height: 900 };

export const graphPage: Bench = {
  name: 'graph-page',
  title: 'The node graph in the page',
  about:
    'Projects of boxes, each moved by a node of its own, opened in the built page at 1440 × 900 by a headless Chromium, WebGL2. *Shown*: from the click on the button to the frame in which all nodes and edges that are in sight are drawn. ' +
    'Frames: between two of them, while the mouse moves, turns its wheel, or drags a node, over the whole graph in sight; all 16.7 where nothing is late. *Edit to picture*: from Enter in a field of the tone map to the frame that shows it, when the GPU has drawn that.',
  async run() {
    const server = await servePage(LLVMPIPE);
    try {
      return [await canvas(server), await pasting(server)];
    } finally {
      await server.close();
    }
  },
};

async function canvas(server: PageServer): Promise<Table> {
  const measured = SIZES.map((): number[][] => []);
  for (let round = 0; round < ROUNDS; round++) {
    for (const [i, size] of SIZES.entries()) measured[i]!.push(await visit(server, size));
  }
  const columns = ['shown', 'pan', 'pan, 95 %', 'zoom', 'zoom, 95 %', 'drag', 'drag, 95 %', 'edit to picture'];
  const rows = measured.map((rounds, i) => [
    String(SIZES[i]),
    ...columns.map((_, column) => median(rounds.map((figures) => figures[column]!))),
  ]);
  return { columns: ['nodes', ...columns.map((column) => `${column} [ms]`)], rows };
}

/** Results in the order of the table's columns. */
async function visit(server: PageServer, size: number): Promise<number[]> {
  const tab = await opened(server, size);
  const shown = await timeOf(tab, 'graph', () => tab.getByRole('button', { name: 'Show the node graph' }).click());
  // Node previews are drawn later, once everything is idle.
  await tab.waitForTimeout(4000);
  const flow = (await tab.locator('.sl-flow').boundingBox())!;
  const [x, y] = [flow.x + flow.width / 2, flow.y + 30];
  const pan = await frames(tab, async () => {
    await tab.mouse.move(x, y);
    await tab.mouse.down({ button: 'middle' });
    await tab.mouse.move(x + 200, y + 60, { steps: STEPS });
    await tab.mouse.move(x, y, { steps: STEPS });
    await tab.mouse.up({ button: 'middle' });
  });
  const zoom = await frames(tab, async () => {
    for (let i = 0; i < 2 * STEPS; i++) await tab.mouse.wheel(0, i < STEPS ? -25 : 25);
  });
  const head = (await tab.locator('.react-flow__node[data-id="merge0"]').boundingBox())!;
  const [left, top] = [head.x + head.width / 2, head.y + Math.min(head.height / 2, 8)];
  const drag = await frames(tab, async () => {
    await tab.mouse.move(left, top);
    await tab.mouse.down();
    await tab.mouse.move(left + 120, top + 40, { steps: STEPS });
    await tab.mouse.move(left, top, { steps: STEPS });
    await tab.mouse.up();
  });
  const figures = [shown, ...pan, ...zoom, ...drag, await editing(tab)];
  await tab.context().close();
  return figures;
}

async function opened(server: PageServer, size: number): Promise<Page> {
  const context = await server.context({
    viewport: VIEWPORT,
    reducedMotion: 'reduce',
    locale: 'en-GB',
    serviceWorkers: 'block',
  });
  const tab = await context.newPage();
  const body = serializeDocument(gridProject(size));
  await tab.route('**/yard.slowlight.json', (route) => route.fulfill({ body, contentType: 'application/json' }));
  await tab.goto(server.address('project=yard.slowlight.json'));
  await tab.locator('[data-status="triangles"]', { hasText: /[1-9]/ }).waitFor({ timeout: 120_000 });
  await tab.waitForTimeout(1500);
  await tab.evaluate(listening);
  return tab;
}

/** Measurements within the page. */
interface Watched {
  /** Resolves in the frame after the canvas or its viewport stopped changing, with the time since the first change [ms]; NaN if nothing changed. */
  settled(): Promise<number>;
  began: number;
  intervals: number[];
  drawn: number;
}
declare global {
  var watched: Watched;
}

/** Evaluated in the page. */
function listening(): void {
  const QUIET = 400;
  const PATIENCE = 60_000;
  let changed = 0;
  const note = (): void => {
    changed = performance.now();
  };
  // It is displayed in the frame after this one.
  const isOfGraph = (node: Node): boolean =>
    node instanceof Element && node.matches('.sl-graph, .react-flow__node, .react-flow__edge, .react-flow__edge *');
  const isOfView = (node: Node): boolean => node instanceof Element && node.matches('.react-flow__viewport');
  const observer = new MutationObserver((records) => {
    const ofGraph = records.some(({ type, target, addedNodes, removedNodes }) =>
      type === 'attributes' ? isOfView(target) : [...addedNodes, ...removedNodes].some(isOfGraph),
    );
    if (ofGraph) requestAnimationFrame(() => requestAnimationFrame(note));
  });
  observer.observe(document.body, { childList: true, subtree: true, attributeFilter: ['style'] });
  let before = performance.now();
  const tick = (now: number): void => {
    watched.intervals.push(now - before);
    before = now;
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
  // Every picture reaches the canvas by full-screen passes.
  const draw = WebGL2RenderingContext.prototype.drawArrays;
  WebGL2RenderingContext.prototype.drawArrays = function (...args) {
    watched.drawn++;
    draw.apply(this, args);
  };
  const later = (ms: number) => new Promise((done) => setTimeout(done, ms));
  globalThis.watched = {
    began: 0,
    intervals: [],
    drawn: 0,
    async settled() {
      while (changed < watched.began || performance.now() - changed < QUIET) {
        if (performance.now() - watched.began > PATIENCE) return Number.NaN;
        await later(20);
      }
      return changed - watched.began;
    },
  };
}

/** From a key press or click to the frame after the last change of the page [ms]. */
async function timeOf(tab: Page, event: string, act: () => Promise<void>): Promise<number> {
  await tab.evaluate(() => {
    const begin = (): void => {
      watched.began = performance.now();
    };
    for (const kind of ['pointerdown', 'keydown', 'paste'])
      addEventListener(kind, begin, { capture: true, once: true });
  });
  await act();
  const time = await tab.evaluate(() => watched.settled());
  if (!(time > 0)) throw new Error(`nothing came of ${event}`);
  return time;
}

/** Median and 95th percentile of frame times during an interaction [ms]. */
async function frames(tab: Page, act: () => Promise<void>): Promise<readonly [median: number, late: number]> {
  await tab.evaluate(() => {
    watched.intervals = [];
  });
  await act();
  const times = (await tab.evaluate(() => watched.intervals)).sort((a, b) => a - b);
  return [median(times), times[Math.floor(0.95 * times.length)] ?? Number.NaN];
}

async function editing(tab: Page): Promise<number> {
  await tab.getByText('Controls', { exact: true }).click();
  const field = tab.getByRole('textbox', { name: 'Exposure' }).first();
  const times: number[] = [];
  for (const value of ['0.5', '1', '0.25', '0.75']) {
    await field.fill(value);
    await tab.waitForTimeout(2500);
    const picture = tab.evaluate(async () => {
      const context = document.querySelector<HTMLCanvasElement>('.sl-canvas')!.getContext('webgl2')!;
      const enter = await new Promise<number>((done) =>
        addEventListener('keydown', () => done(performance.now()), { capture: true, once: true }),
      );
      const before = watched.drawn;
      const patience = performance.now() + 20_000;
      while (watched.drawn === before && performance.now() < patience) await new Promise(requestAnimationFrame);
      // Waits for the GPU.
      context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
      return performance.now() - enter;
    });
    await field.press('Enter');
    times.push(await picture);
  }
  return median(times);
}

async function pasting(server: PageServer): Promise<Table> {
  const document = gridProject(PASTED);
  const words = serializeFragment(copyFragment(document, { nodes: Object.keys(document.nodes) }));
  const tab = await opened(server, SIZES[0]!);
  await tab.getByRole('button', { name: 'Show the node graph' }).click();
  await tab.waitForTimeout(3000);
  const press = (keys: string) => () => tab.keyboard.press(keys);
  const rounds: number[][] = [];
  for (let round = 0; round < ROUNDS; round++) {
    await tab.locator('.sl-flow').focus();
    const pasted = await timeOf(tab, 'paste', () =>
      tab.evaluate((text) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', text);
        const { activeElement } = globalThis.document;
        activeElement?.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
      }, words),
    );
    const whole = await timeOf(tab, 'Home', press('Home'));
    const undone = await timeOf(tab, 'undo', press('Control+z'));
    rounds.push([pasted, whole, undone]);
  }
  await tab.context().close();
  const [paste, home, undo] = [0, 1, 2].map((i) => median(rounds.map((figures) => figures[i]!)));
  return {
    columns: ['nodes', 'paste [ms]', 'then all in sight [ms]', 'undo of the paste [ms]'],
    rows: [[PASTED.toLocaleString('en'), paste!, home!, undo!]],
    remark: 'Into the project of 30 nodes, until the frame that shows it.',
  };
}
