import { randomUUID } from 'node:crypto';
import { relative } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { MotionChange } from '../scene/change.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { unavailable } from './exit.ts';
import { findScene } from './files.ts';
import { speedOfLight } from './flags.ts';
import { findChromium } from './icd.ts';
import type { Painter, Picture, PictureRequest } from './painter.ts';
import { isProject } from './project.ts';
import type { RenderFlags } from './render.ts';
import { motionChange, readOptions } from './scene.ts';
import { serveApp } from './staticServer.ts';

/** What the page headless.html offers to whoever drives it; src/app/headless.ts is the other end and says what it means. */
interface HeadlessPage {
  open(request: {
    base: string;
    entry: string;
    width: number;
    height: number;
    animation?: string | number;
    interpolation?: 'linear' | 'cubic';
    subdivision?: number;
    variants: (readonly [set: string, option: string])[];
    motion: MotionChange & { speedOfLight: number };
  }): Promise<{ adapterName: string }>;
  render(request: {
    view: ViewPoint;
    settings: RenderSettings;
    samples: number;
    aovs: readonly AovName[];
  }): Promise<{ pixels: string; aovs: Partial<Record<AovName, string>> }>;
}
/** The page's window, as seen by the functions below that run in it. */
type HeadlessWindow = { readonly slowlight: HeadlessPage };

/** Draws with the page's renderer on WebGL2, in a Chromium without a window. */
export async function openWebGlPainter(path: string, scene: Scene, flags: RenderFlags): Promise<Painter> {
  if (await isProject(path))
    throw unavailable('WebGL2 in a browser draws scene files, not projects: take webgpu, or --pipeline reference');
  const { source, folder, entry } = await findScene(path);
  const { animation, subdivision, variants = [] } = readOptions(flags);
  const motion = { ...motionChange(flags), speedOfLight: speedOfLight(scene, flags.c) };
  // A name that nobody else on this machine can guess: whatever the scene refers to can be read below it, as `..` leads.
  const files = `/${randomUUID()}/`;
  const server = await serveApp(0, async (url) =>
    url.startsWith(files) ? source.read(relative(folder, absolutePath(url.slice(files.length)))) : undefined,
  );
  let browser: Browser | undefined;
  const close = async (): Promise<void> => {
    await browser?.close();
    await server.close();
  };
  try {
    browser = await launch();
    const page = await openPage(browser, `${server.url}/headless.html`);
    const { adapterName } = await page.evaluate(
      (request) => (window as unknown as HeadlessWindow).slowlight.open(request),
      {
        base: `${server.url}${files}${addressOf(folder)}/`,
        entry,
        ...flags.size,
        animation,
        subdivision,
        variants: [...variants],
        motion,
      },
    );
    const info = { pipeline: 'raster', backend: 'webgl', adapter: adapterName } as const;
    return { info, usualSamples: 1, paint: (request) => paint(page, request), close };
  } catch (error) {
    await close();
    throw error;
  }
}

/** `/home/me/a scene` → `home/me/a%20scene`, and back. On Windows a path begins with its drive instead. */
const addressOf = (folder: string): string => encodeURI(folder.replaceAll('\\', '/').replace(/^\//, ''));
const absolutePath = (address: string): string => (process.platform === 'win32' ? address : `/${address}`);

async function launch(): Promise<Browser> {
  const executablePath = findChromium();
  if (!executablePath) {
    throw unavailable(
      '--backend webgl needs Chromium, which is not on the PATH (CHROMIUM may name it). On Debian or Ubuntu: apt-get install -y chromium libegl-mesa0 libgl1-mesa-dri',
    );
  }
  const { chromium } = await import('playwright-core');
  const gl = process.platform === 'linux' ? ['--use-gl=angle', '--use-angle=gl-egl'] : [];
  const starting = chromium.launch({
    executablePath,
    headless: true,
    handleSIGINT: false,
    handleSIGTERM: false,
    args: [...gl, '--ignore-gpu-blocklist'],
  });
  return starting.catch((error: unknown) => {
    throw unavailable(`Chromium (${executablePath}) does not start: ${complaints(String(error))}`);
  });
}

/** Of Playwright's long report: what went wrong, and what the browser itself said of it. */
function complaints(report: string): string {
  const [first, ...rest] = report.split('\n');
  const said = rest.flatMap((line) => /\[err\] (.*)/.exec(line)?.[1] ?? []);
  return [first, ...new Set(said)].slice(0, 3).join('; ');
}

async function openPage(browser: Browser, url: string): Promise<Page> {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await page.goto(url);
  if (!(await page.evaluate(() => 'slowlight' in window))) {
    throw new Error(`the page headless.html did not start: ${errors.join('; ') || 'no reason given'}`);
  }
  if (!(await page.evaluate(() => document.createElement('canvas').getContext('webgl2') !== null))) {
    throw unavailable(
      'the Chromium here has no WebGL2. On Debian or Ubuntu: apt-get install -y libegl-mesa0 libgl1-mesa-dri',
    );
  }
  return page;
}

async function paint(page: Page, request: PictureRequest): Promise<Picture> {
  const { pixels, aovs } = await page.evaluate(
    (wanted) => (window as unknown as HeadlessWindow).slowlight.render(wanted),
    request,
  );
  const data = Object.entries(aovs).map(([name, text]) => [name as AovName, floats(text)] as const);
  return { pixels: new Uint8Array(Buffer.from(pixels, 'base64')), aovs: new Map(data) };
}

/** A copy, because a Buffer may start at any byte of its memory. */
const floats = (base64: string): Float32Array => new Float32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer);
