import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium } from 'playwright-core';
import { findChromium, SOFTWARE_GPU_FLAGS } from '../../src/cli/gpu/gpuDrivers.ts';
import { type Bench, median, timed } from '../support/bench.ts';

const bin = fileURLToPath(new URL('../../../../bin/slowlight.js', import.meta.url));
const ROUNDS = 3;

export const page: Bench = {
  name: 'page',
  title: 'From opening the page to its first picture',
  about:
    'The built page served from this machine to a headless Chromium with an empty cache, until the status bar counts the triangles of the first picture of `street`.',
  async run() {
    const server = spawn(process.execPath, [bin, 'serve', '--port', '0', '--json'], {
      stdio: ['ignore', 'pipe', 'inherit'],
    });
    const [line] = (await once(server.stdout, 'data')) as [Buffer];
    const { url } = JSON.parse(line.toString()) as { url: string };
    const browser = await chromium.launch({
      executablePath: findChromium() ?? 'chromium',
      headless: true,
      args: [...SOFTWARE_GPU_FLAGS],
    });
    try {
      const rows: (string | number)[][] = [];
      for (const backend of ['webgpu', 'webgl']) rows.push([backend, await firstPicture(browser, url, backend)]);
      return [{ columns: ['backend', 'time [s]'], rows }];
    } finally {
      await browser.close();
      server.kill();
    }
  },
};

async function firstPicture(browser: Browser, url: string, backend: string): Promise<number> {
  const times: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const context = await browser.newContext({ viewport: { width: 960, height: 600 } });
    const tab = await context.newPage();
    const ms = await timed(async () => {
      await tab.goto(`${url}/?backend=${backend}&scene=examples/street.usdc`);
      await tab.locator('[data-status="triangles"]', { hasText: /[1-9]/ }).waitFor({ timeout: 120_000 });
    });
    times.push(ms / 1000);
    await context.close();
  }
  return median(times);
}
