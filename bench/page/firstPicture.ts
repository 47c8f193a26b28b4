import type { BrowserContext, Page } from 'playwright-core';
import { type Bench, median } from '../support/bench.ts';
import { GRAPHICS, mainThreadTime, type PageServer, servePage } from './browsers.ts';

const ROUNDS = 3;

export const firstPicture: Bench = {
  name: 'first-picture',
  title: 'From opening the page to its first picture',
  about:
    'The built page served from this machine to a headless Chromium in a window of 960 × 600, scene `street`, medians of three. *Poster*: the example’s thumbnail is shown. *First visit*: with an empty cache. *Second visit*: with what the browser and the service worker kept. *Without a network*: the same, with the server out of reach. *Main thread*: what it was busy for, until the picture of the first visit.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const graphics of GRAPHICS) {
      const server = await servePage(graphics);
      try {
        const visits: Awaited<ReturnType<typeof visitThrice>>[] = [];
        for (let round = 0; round < ROUNDS; round++) visits.push(await visitThrice(server));
        const column = (name: keyof (typeof visits)[number]) => median(visits.map((visit) => visit[name]));
        rows.push([
          graphics.name,
          column('poster'),
          column('first'),
          column('second'),
          column('offline'),
          column('mainThread'),
        ]);
      } finally {
        await server.close();
      }
    }
    const columns = [
      'graphics',
      'poster [s]',
      'first visit [s]',
      'second visit [s]',
      'without a network [s]',
      'main thread [s]',
    ];
    return [{ columns, rows }];
  },
};

async function visitThrice(server: PageServer) {
  const context = await server.context();
  const address = server.address('scene=examples/street.usdc');
  try {
    const { tab, poster, picture: first, mainThread } = await visit(context, address);
    await tab.evaluate(() => navigator.serviceWorker.ready);
    await tab.close();
    const { picture: second } = await visitAndClose(context, address);
    await context.setOffline(true);
    const { picture: offline } = await visitAndClose(context, address);
    return { poster, first, second, offline, mainThread };
  } finally {
    await context.close();
  }
}

async function visitAndClose(context: BrowserContext, address: string) {
  const times = await visit(context, address);
  await times.tab.close();
  return times;
}

/** Times since the visit began [s]. */
async function visit(context: BrowserContext, address: string) {
  const tab = await context.newPage();
  await tab.addInitScript(markPoster);
  const busy = await mainThreadTime(tab);
  await tab.goto(address);
  await tab.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0, null, { timeout: 300_000 });
  return {
    tab,
    poster: await markOf(tab, 'poster'),
    picture: await markOf(tab, 'first-picture'),
    mainThread: await busy(),
  };
}

const markOf = (tab: Page, name: string): Promise<number> =>
  tab.evaluate((mark) => (performance.getEntriesByName(mark)[0]?.startTime ?? Number.NaN) / 1000, name);

/** Runs in the page. */
function markPoster(): void {
  const look = (): void => {
    const poster = document.querySelector<HTMLImageElement>('.sl-poster');
    if (poster?.complete && poster.naturalWidth > 0) performance.mark('poster');
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}
