import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type DecodedPng, decode } from 'fast-png';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { afterAll, afterEach, expect } from 'vitest';
import { SOFTWARE_GPU_FLAGS } from '../../src/cli/gpu/gpuDrivers.ts';

const bin = fileURLToPath(new URL('../../bin/slowlight.js', import.meta.url));

/** As the polls' (vitest.config.ts) [ms]. */
const PATIENCE = 180_000;

/** Size of the window, where a test asks for no other. */
export const WINDOW = { width: 960, height: 600 };

/** Folder of screenshots of a run, for inspection. */
export const shots = process.env.E2E_SHOTS ?? mkdtempSync(join(tmpdir(), 'slowlight-e2e-'));

/** The built program, served as by `npm start`, and a browser. */
export class Program {
  readonly url: string;
  private readonly server: ChildProcess;
  private readonly browser: Browser;

  static async start(): Promise<Program> {
    const server = spawn(process.execPath, [bin, 'serve', '--port', '0', '--json'], {
      stdio: ['ignore', 'pipe', 'inherit'],
    });
    const [line] = (await once(server.stdout, 'data')) as [Buffer];
    const { url } = JSON.parse(line.toString()) as { url: string };
    const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
    return new Program(
      url,
      server,
      await chromium.launch({ executablePath, headless: true, args: [...SOFTWARE_GPU_FLAGS] }),
    );
  }

  private constructor(url: string, server: ChildProcess, browser: Browser) {
    this.url = url;
    this.server = server;
    this.browser = browser;
  }

  /** Opens a page in a new browser context, without stored data. `address`: appended to the program's URL. */
  async open(
    address = '',
    options: BrowserContextOptions = {},
    prepare?: (page: Page) => Promise<void>,
  ): Promise<MonitoredPage> {
    const context = await this.browser.newContext({
      viewport: WINDOW,
      reducedMotion: 'reduce',
      colorScheme: 'dark',
      locale: 'en-GB',
      // It would answer what tests let wait or fail.
      serviceWorkers: 'block',
      ...options,
    });
    context.setDefaultTimeout(PATIENCE);
    const page = await context.newPage();
    const guarded = new MonitoredPage(page, this.url);
    await prepare?.(page);
    await page.goto(`${this.url}/${address}`);
    return guarded;
  }

  /** Opens another tab in the context of a page, which shares its stored data. */
  async beside({ page }: MonitoredPage, address: string): Promise<MonitoredPage> {
    const guarded = new MonitoredPage(await page.context().newPage(), this.url);
    await guarded.page.goto(`${this.url}/${address}`);
    return guarded;
  }

  /** Crashes the GPU process: every page loses its device or context. */
  async crashGraphics(): Promise<void> {
    const session = await this.browser.newBrowserCDPSession();
    await session.send('Browser.crashGpuProcess').catch(() => {});
  }

  async stop(): Promise<void> {
    await this.browser.close();
    this.server.kill();
  }
}

/**
 * A page that several tests use one after another, because opening one takes longer than most tests. Each leaves
 * dialogues, notices, modes and window as it found them, not the scene; after one that fails, or causes complaints, the
 * next gets a new page. Returns what opens the page the first time.
 */
export function sharedPage(open: () => Promise<MonitoredPage>): () => Promise<MonitoredPage> {
  let shared: MonitoredPage | undefined;
  afterEach(async ({ task }) => {
    const used = shared;
    if (!used || (task.result?.state !== 'fail' && used.complaints.length === 0)) return;
    shared = undefined;
    await used.close();
  });
  afterAll(() => shared?.close());
  return async () => {
    shared ??= await open();
    return shared;
  };
}

/** A page whose errors and requests to other origins are recorded. */
export class MonitoredPage {
  readonly page: Page;
  readonly complaints: string[] = [];

  constructor(page: Page, origin: string) {
    this.page = page;
    page.on('pageerror', (error) => this.complaints.push(`page: ${error.message}`));
    page.on('console', (message) => {
      if (message.type() === 'error') this.complaints.push(`console: ${message.text()}`);
    });
    page.on('request', (request) => {
      const url = request.url();
      if (!url.startsWith(origin) && !/^(data|blob):/.test(url)) this.complaints.push(`asks elsewhere: ${url}`);
    });
  }

  /** Closes the page, and expects no errors and no requests to other origins. */
  async close(): Promise<void> {
    const complaints = [...this.complaints];
    await this.page.context().close();
    expect(complaints).toEqual([]);
  }

  /** Expects a complaint that matches `about`, and removes all that match. */
  expectComplaint(about: RegExp): void {
    const rest = this.complaints.filter((complaint) => !about.test(complaint));
    expect(rest.length, `a complaint about ${about}`).toBeLessThan(this.complaints.length);
    this.complaints.splice(0, this.complaints.length, ...rest);
  }

  /** Chooses the page's language by its own name: 中文. */
  async chooseLanguage(name: string): Promise<void> {
    await this.page.getByRole('button', { name: /^(?:Language|语言)$/ }).click();
    await this.page.getByRole('menuitem', { name, exact: true }).click();
  }

  /** Waits until the scene is open and drawn. */
  async ready(): Promise<this> {
    await this.page.locator('[data-status="backend"]', { hasText: 'Web' }).waitFor();
    await expect.poll(() => this.triangles()).toBeGreaterThan(0);
    return this;
  }

  /** Waits until the page has ticked once since the call. */
  async ticked(): Promise<void> {
    await this.page.evaluate(() => new Promise((ticked) => requestAnimationFrame(() => requestAnimationFrame(ticked))));
  }

  /** Waits until the picture is final: the last request is drawn with all samples and metered exposure. */
  async finest(): Promise<this> {
    await this.ticked();
    await this.page.locator('canvas[data-finest]').waitFor();
    return this;
  }

  /** Waits until nothing fades or slides any more. */
  async settled(): Promise<this> {
    await this.page.waitForFunction(() =>
      document
        .getAnimations()
        .every(({ playState, effect }) => playState !== 'running' || effect?.getTiming().iterations === Infinity),
    );
    return this;
  }

  /** Opens a scene or project by `act`, and waits until it is the one that the page shows. */
  async opens(act: () => Promise<void>): Promise<void> {
    const opened = () => this.page.locator('[data-opened]').getAttribute('data-opened');
    const before = await opened();
    await act();
    await expect.poll(opened).not.toBe(before);
  }

  async status(id: string): Promise<string> {
    return (await this.page.locator(`[data-status="${id}"]`).textContent()) ?? '';
  }

  /** The displayed speed [c]. */
  async speed(): Promise<number> {
    return Number(/([\d.]+) c$/.exec(await this.status('speed'))?.[1]);
  }

  async triangles(): Promise<number> {
    return Number((await this.status('triangles')).replace(/\D/g, ''));
  }

  get viewport() {
    return this.page.locator('[data-viewport]');
  }

  /** Notices of errors. */
  get refusals() {
    return this.page.locator('.sl-notices').getByRole('alert');
  }

  async shot(name: string): Promise<void> {
    expect(await this.page.content(), 'a message put into a string').not.toContain('[object Object]');
    await this.page.screenshot({ path: join(shots, `${name}.png`) });
  }

  /** The displayed pixels of the picture, without overlays. */
  async pixels(): Promise<Uint8Array> {
    return Uint8Array.from((await this.picture()).data);
  }

  /** Red, green and blue of the middle pixel. */
  async middle(): Promise<readonly number[]> {
    const { data, width, height, channels } = await this.picture();
    const at = channels * (Math.floor(height / 2) * width + Math.floor(width / 2));
    return [...data.slice(at, at + 3)];
  }

  private async picture(): Promise<DecodedPng> {
    const style =
      '.sl-hint, .sl-caption, .sl-legend, .sl-crosshair, .sl-notices, .sl-busy, .sl-vignette, .sl-picture::after { visibility: hidden !important }';
    return decode(await this.page.locator('.sl-canvas').screenshot({ style }));
  }
}

/** Number of different colours; 1 for a blank picture. */
export const colorCount = (pixels: Uint8Array): number => {
  const seen = new Set<number>();
  for (let i = 0; i + 2 < pixels.length; i += 3) seen.add((pixels[i]! << 16) | (pixels[i + 1]! << 8) | pixels[i + 2]!);
  return seen.size;
};

/** Mean difference per channel, 0 … 255. */
export const difference = (a: Uint8Array, b: Uint8Array): number =>
  a.length === b.length ? a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0) / a.length : 255;
