import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { type BrowserContext, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { findChromium, SOFTWARE_GPU_FLAGS } from '../../src/cli/gpu/gpuDrivers.ts';

const bin = fileURLToPath(new URL('../../../../bin/slowlight.js', import.meta.url));

/** A backend of the page, on one of the drivers that draw on the processor. */
interface Graphics {
  readonly name: string;
  readonly backend: 'webgl' | 'webgpu';
  readonly flags: readonly string[];
}

/** What the page draws with by itself where there is no GPU. */
export const LLVMPIPE: Graphics = { name: 'WebGL2, llvmpipe', backend: 'webgl', flags: SOFTWARE_GPU_FLAGS };
/** What browsers draw with where there is no GPU. */
export const GRAPHICS: readonly Graphics[] = [
  LLVMPIPE,
  {
    name: 'WebGL2, SwiftShader',
    backend: 'webgl',
    flags: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  },
  { name: 'WebGPU, SwiftShader', backend: 'webgpu', flags: SOFTWARE_GPU_FLAGS },
];

/** The built page on this machine, and a browser. */
export interface PageServer {
  /** A browser without stored data; by default in a window of 960 × 600. */
  context(options?: BrowserContextOptions): Promise<BrowserContext>;
  /** With a query besides the backend: `scene=examples/street.usdc`. */
  address(query: string): string;
  close(): Promise<void>;
}

export async function servePage({ backend, flags }: Graphics): Promise<PageServer> {
  const server = spawn(process.execPath, [bin, 'serve', '--port', '0', '--json'], {
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  const [line] = (await once(server.stdout, 'data')) as [Buffer];
  const { url } = JSON.parse(line.toString()) as { url: string };
  const executablePath = findChromium() ?? 'chromium';
  const browser = await chromium.launch({ executablePath, headless: true, args: [...flags] });
  return {
    context: (options) => browser.newContext({ viewport: { width: 960, height: 600 }, ...options }),
    address: (query) => `${url}/?backend=${backend}&${query}`,
    async close() {
      await browser.close();
      server.kill();
    },
  };
}

/** Returns what tells how long the page's main thread has been busy since the call [s]. */
export async function mainThreadTime(tab: Page): Promise<() => Promise<number>> {
  const session = await tab.context().newCDPSession(tab);
  await session.send('Performance.enable');
  const busy = async (): Promise<number> => {
    const { metrics } = await session.send('Performance.getMetrics');
    return metrics.find(({ name }) => name === 'TaskDuration')?.value ?? Number.NaN;
  };
  const before = await busy();
  return async () => (await busy()) - before;
}
