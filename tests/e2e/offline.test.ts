import { once } from 'node:events';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { MonitoredPage, Program } from './program.ts';

const KEPT = { serviceWorkers: 'allow' } as const;
const SMALL = '?backend=webgl&scene=examples/sphere.usdc';

let program: Program;
let running: Host | undefined;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());
afterEach(() => {
  running?.stop();
  running = undefined;
});

/** A host on the network that deploys the page: it may be replaced by a later version, and it may be gone. */
class Host {
  /** A later version has other names for all its parts, and no longer those of the one before. */
  isUpdated = false;
  url = '';
  private readonly server: Server;

  static async start(): Promise<Host> {
    const host = new Host();
    host.server.listen(0, '127.0.0.1');
    await once(host.server, 'listening');
    host.url = `http://127.0.0.1:${(host.server.address() as AddressInfo).port}`;
    return host;
  }

  private constructor() {
    this.server = createServer(async ({ url = '/' }, response) => {
      const original = await fetch(new URL(url, program.url));
      const { status, body } = this.isUpdated ? await this.updated(url, original) : original;
      response.writeHead(status, { 'content-type': original.headers.get('content-type') ?? '' });
      for await (const part of body ?? []) response.write(part);
      response.end();
    });
  }

  stop(): void {
    this.server.close();
    this.server.closeAllConnections();
  }

  private async updated(url: string, original: Response): Promise<Response> {
    if (url.startsWith('/assets/')) return new Response('', { status: 404 });
    if (url === '/serviceWorker.js') {
      const script = await original.text();
      const files = /\[\{"revision":.*?\}\]/.exec(script)?.[0] ?? '';
      return new Response(script.replace(files, '[{"revision":"2","url":"index.html"}]'));
    }
    if (/^\/(?:index.html)?(?:\?|$)/.test(url)) return new Response('<!doctype html><title>Version 2</title>');
    return original;
  }
}

/** Opens the page at the host for the first time, until the browser has kept it. */
async function firstVisit(address: string): Promise<{ readonly visit: MonitoredPage; readonly host: Host }> {
  const host = await Host.start();
  running = host;
  // The program opens its own address, which is of no use here.
  const { page: other } = await program.open('examples/index.json', KEPT);
  const visit = new MonitoredPage(await other.context().newPage(), host.url);
  await other.close();
  await visit.page.goto(`${host.url}/${address}`);
  await visit.ready();
  await visit.page.evaluate(() => navigator.serviceWorker.ready);
  await visit.page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  return { visit, host };
}

describe('the page without a network', () => {
  it('opens at the second visit, with examples and parts that were not opened before', async () => {
    const { visit, host } = await firstVisit(SMALL);
    const { page } = visit;
    host.stop();
    await page.reload();
    await visit.ready();
    await visit.opens(async () => {
      await page.getByRole('button', { name: 'Scenes' }).click();
      await page
        .getByRole('button', { name: /Cobblestone|Dice|dice/ })
        .first()
        .click();
    });
    await visit.ready();
    await page.keyboard.press('?');
    await page.getByRole('dialog').getByText('Full speed').first().waitFor();
    await visit.shot('offline');
    await page.goto(`${host.url}/?backend=webgl&project=examples/workshop.slowlight.json`);
    await visit.ready();
    await visit.close();
  });

  it('names the file that it does not have', async () => {
    const { visit, host } = await firstVisit(SMALL);
    const { page } = visit;
    host.stop();
    await page.goto(`${host.url}/?backend=webgl&scene=mine/castle.usda`);
    await visit.refusals
      .filter({ hasText: 'castle.usda: nothing answers at its address. Check the network' })
      .waitFor();
    await visit.close();
  });

  it('an open tab keeps its version and its work until it is closed, while new tabs have the new one', async () => {
    const { visit, host } = await firstVisit(SMALL);
    const { page } = visit;
    await page.getByRole('radiogroup', { name: 'View' }).getByText('c = ∞').click();
    await expect.poll(() => page.title()).toContain('•');
    host.isUpdated = true;
    await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
    await page.waitForFunction(async () => (await navigator.serviceWorker.ready).waiting?.state === 'installed');
    // The graph was not loaded yet, and the server no longer has it.
    await page.keyboard.press('Control+Shift+G');
    await page.locator('.react-flow__node').first().waitFor();
    expect(await page.title()).toContain('•');
    const beside = await page.context().newPage();
    await beside.goto(host.url);
    expect(await beside.title()).toBe('Version 2');
    await beside.close();
    await visit.close();
  });
});

describe('the installed program', () => {
  it('has what browsers ask for', async () => {
    const visit = await program.open(SMALL, KEPT);
    const session = await visit.page.context().newCDPSession(visit.page);
    const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
    const { errors } = await session.send('Page.getAppManifest');
    // Contexts of tests are private windows.
    expect(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== 'in-incognito')).toEqual([]);
    expect(errors).toEqual([]);
    await visit.ready();
    await visit.close();
  });

  it('is offered in the menu where the browser offers it', async () => {
    const visit = await program.open(SMALL);
    const { page } = visit;
    await visit.ready();
    const menu = page.getByRole('button', { name: 'Project', exact: true });
    const offer = page.getByRole('menuitem', { name: 'Install as a program…' });
    await menu.click();
    await page.getByRole('menuitem', { name: 'Save project' }).waitFor();
    expect(await offer.count()).toBe(0);
    await page.keyboard.press('Escape');
    const asked = page.evaluate(
      () =>
        new Promise((prompt) => {
          dispatchEvent(
            Object.assign(new Event('beforeinstallprompt', { cancelable: true }), { prompt: () => prompt(true) }),
          );
        }),
    );
    await menu.click();
    await offer.click();
    expect(await asked).toBe(true);
    await menu.click();
    await page.getByRole('menuitem', { name: 'Save project' }).waitFor();
    expect(await offer.count()).toBe(0);
    await visit.close();
  });
});
