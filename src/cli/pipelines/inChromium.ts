import { randomUUID } from 'node:crypto';
import type { Browser, Page } from 'playwright-core';
import { msg } from '../../messages/message.ts';
import { withFilms, withoutFilms } from '../../pipelines/films/withFilms.ts';
import type { HeadlessPage } from '../../pipelines/headlessPage.ts';
import { assertPictureSize } from '../../pipelines/maxSize.ts';
import type { PictureRequest, RenderedPicture } from '../../pipelines/pictureRenderer.ts';
import type { Pipeline, PipelineSession, UncheckedRequest } from '../../pipelines/pipeline.ts';
import type { DomeMaps } from '../../render/lights/sky/domeMaps.ts';
import { encodeTransfer } from '../../scene/transfer/transferCodec.ts';
import type { LightMeterReadings } from '../../scene/view/metering.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../../scene/view/view.ts';
import { readDiskFile } from '../files/diskFiles.ts';
import { findChromium } from '../gpu/gpuDrivers.ts';
import { serveApp } from '../serve/staticServer.ts';
import { unavailable } from '../terminal/exitCodes.ts';
import { nodeHost } from './nodeHost.ts';

/** The page's window, for functions that are evaluated in it. */
type HeadlessWindow = { readonly slowlight: HeadlessPage };

/** Opens a pipeline on WebGL2 in a headless Chromium. Scenes are read in this process and transferred. */
export async function openInChromium(
  { id }: Pick<Pipeline, 'id'>,
  { scenes, size: { width, height } }: Pick<UncheckedRequest, 'scenes' | 'size'>,
): Promise<PipelineSession> {
  let dome: DomeMaps | undefined;
  // Unguessable for other users of this machine: the second serves the files in which samples were left.
  const [sent, domes, files] = [`/${randomUUID()}`, `/${randomUUID()}`, `/${randomUUID()}/`];
  const server = await serveApp(0, async (url) => {
    if (url === sent) return encodeTransfer(withoutFilms(scenes));
    if (url === domes) return dome && encodeTransfer(dome);
    return url.startsWith(files) ? partOfFile(url.slice(files.length)) : undefined;
  });
  let browser: Browser | undefined;
  const close = async (): Promise<void> => {
    await browser?.close();
    await server.close();
  };
  try {
    browser = await launch();
    const page = await openPage(browser, `${server.url}/headless.html`);
    const { adapterName, largest } = await page.evaluate(
      (pipeline) => (window as unknown as HeadlessWindow).slowlight.start(pipeline),
      id,
    );
    assertPictureSize({ width, height }, largest);
    await page.evaluate((request) => (window as unknown as HeadlessWindow).slowlight.open(request), {
      scenes: sent,
      files,
      width,
      height,
    });
    const session: PipelineSession = {
      info: { pipeline: id, backend: 'webgl', adapter: adapterName },
      render: (request) => renderPicture(page, request),
      measureLight: (views, settings) => measureLight(page, views, settings),
      showDome: {
        needsMaps: true,
        show: async (index, { maps }) => {
          dome = maps;
          const order = { index, maps: domes };
          await page.evaluate((request) => (window as unknown as HeadlessWindow).slowlight.showDome(request), order);
        },
      },
      close,
    };
    return withFilms(session, scenes, nodeHost.openFilm);
  } catch (error) {
    await close();
    throw error;
  }
}

/** `address` is `offset/length/{file handle as JSON}`. */
function partOfFile(address: string): Uint8Array | undefined {
  const [, at, length, handle] = /^(\d+)\/(\d+)\/(.*)$/s.exec(address) ?? [];
  if (handle === undefined) return undefined;
  return readDiskFile({ name: '', handle: JSON.parse(handle) }, Number(at), Number(length));
}

async function launch(): Promise<Browser> {
  const executablePath = findChromium();
  if (!executablePath) {
    throw unavailable(
      msg`--backend webgl needs Chromium, which is not on the PATH (CHROMIUM may name it). On Debian or Ubuntu: apt-get install -y chromium libegl-mesa0 libgl1-mesa-dri`,
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
    throw unavailable(msg`Chromium (${executablePath}) does not start: ${launchErrors(String(error))}`);
  });
}

/** The first line of Playwright's report and up to two error lines of the browser. */
function launchErrors(report: string): string {
  const [first, ...rest] = report.split('\n');
  const errors = rest.flatMap((line) => /\[err\] (.*)/.exec(line)?.[1] ?? []);
  return [first, ...new Set(errors)].slice(0, 3).join('; ');
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
      msg`the Chromium here has no WebGL2. On Debian or Ubuntu: apt-get install -y libegl-mesa0 libgl1-mesa-dri`,
    );
  }
  return page;
}

async function renderPicture(page: Page, request: PictureRequest): Promise<RenderedPicture> {
  const { pixels, aovs } = await page.evaluate(
    (argument) => (window as unknown as HeadlessWindow).slowlight.render(argument),
    request,
  );
  const data = Object.entries(aovs).map(([name, text]) => [name as AovName, floats(text)] as const);
  return { pixels: new Uint8Array(Buffer.from(pixels, 'base64')), aovs: new Map(data) };
}

async function measureLight(page: Page, views: PictureViews, settings: RenderSettings): Promise<LightMeterReadings> {
  const { luminance, doppler, time } = await page.evaluate(
    (argument) => (window as unknown as HeadlessWindow).slowlight.measure(argument),
    { views, settings },
  );
  return { luminance: floats(luminance), doppler: floats(doppler), time: floats(time) };
}

/** Copied, because a Buffer may be unaligned in its memory. */
const floats = (base64: string): Float32Array => new Float32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer);
