import type { Page } from 'playwright-core';
import type { Bench } from '../support/bench.ts';
import { GRAPHICS, mainThreadTime, servePage } from './browsers.ts';

const SCENES = ['street', 'sphere', 'arcade'];
/** A flight is measured for so long [s]. */
const DURATION = 8;

export const weak: Bench = {
  name: 'weak',
  title: 'Flying in the page without a GPU',
  about: `A headless Chromium in a window of 960 × 600, in flight forwards for ${DURATION} s, after all shaders have been compiled. *Main thread*: what it was busy for, per picture; drawing itself is done by another process on the same processors. *Longest*: between two pictures.`,
  async run() {
    const rows: (string | number)[][] = [];
    for (const graphics of GRAPHICS) {
      const server = await servePage(graphics);
      try {
        for (const scene of SCENES) {
          // Keeping the page for offline use would take the processor from the flight.
          const context = await server.context({ serviceWorkers: 'block' });
          const tab = await context.newPage();
          await tab.addInitScript(countPictures);
          await tab.goto(server.address(`scene=examples/${scene}.usdc`));
          rows.push([graphics.name, scene, ...(await fly(tab))]);
          await context.close();
        }
      } finally {
        await server.close();
      }
    }
    const columns = ['graphics', 'scene', 'pictures per second', 'main thread [ms per picture]', 'longest [ms]'];
    return [{ columns, rows }];
  },
};

interface Counted {
  readonly pictureTimes: number[];
}

async function fly(tab: Page): Promise<number[]> {
  const drawn = () => tab.evaluate(() => (globalThis as unknown as Counted).pictureTimes.length);
  await tab.locator('canvas[data-finest]').waitFor({ timeout: 300_000 });
  // Shaders that flights need are tried out after the first picture.
  for (let before = -1; before !== (await drawn()); ) {
    before = await drawn();
    await tab.waitForTimeout(5000);
  }
  await tab.locator('[data-viewport]').focus();
  await tab.keyboard.down('w');
  await tab.waitForTimeout(2000);
  const [busy, before] = [await mainThreadTime(tab), await drawn()];
  await tab.waitForTimeout(1000 * DURATION);
  const [seconds, times] = [await busy(), await tab.evaluate(() => (globalThis as unknown as Counted).pictureTimes)];
  await tab.keyboard.up('w');
  const flown = times.slice(before);
  const pauses = flown.slice(1).map((time, i) => time - flown[i]!);
  return [flown.length / DURATION, (1000 * seconds) / flown.length, Math.max(...pauses)];
}

/** Runs in the page: notes when pictures are drawn, at most one per frame. */
function countPictures(): void {
  const counted: Counted = { pictureTimes: [] };
  Object.assign(globalThis, counted);
  let frame = 0;
  const next = (time: number): void => {
    frame = time;
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
  const watch = (prototype: object | undefined, names: readonly string[]): void => {
    for (const name of names) {
      const draw = (prototype as Record<string, (...args: unknown[]) => unknown> | undefined)?.[name];
      if (!draw) continue;
      Object.assign(prototype!, {
        [name](this: unknown, ...args: unknown[]) {
          if (counted.pictureTimes.at(-1) !== frame) counted.pictureTimes.push(frame);
          return draw.apply(this, args);
        },
      });
    }
  };
  watch(WebGL2RenderingContext.prototype, [
    'drawArrays',
    'drawElements',
    'drawArraysInstanced',
    'drawElementsInstanced',
  ]);
  watch(globalThis.GPUQueue?.prototype, ['submit']);
}
