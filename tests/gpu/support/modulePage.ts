import { type Browser, chromium, type Page } from 'playwright-core';
import { build } from 'vite';
import { findChromium, SOFTWARE_GPU_FLAGS } from '../../../src/cli/gpu/gpuDrivers.ts';

/** A page with one module of this repository. */
export interface ModulePage {
  readonly page: Page;
  /** Throws if the page has thrown or logged an error since it was opened. */
  assertHealthy(): void;
  close(): Promise<void>;
}

/** Bundles `entry` (an absolute path) and opens it in Chromium; functions that it puts on `window` can be called through `page`. */
export async function openModulePage(entry: string): Promise<ModulePage> {
  const [code, browser] = await Promise.all([bundle(entry), launchChromium()]);
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  await page.setContent('<!doctype html><title>Slowlight: shader tests</title>');
  // A module runs asynchronously after it is added.
  await page.addScriptTag({ content: `${code}\nwindow.hasRun = true;`, type: 'module' });
  await page.waitForFunction('window.hasRun').catch((error) => {
    throw new Error(`the page's module did not run: ${errors.join('\n') || error}`);
  });
  return {
    page,
    assertHealthy: () => {
      if (errors.length > 0) throw new Error(`the page reported: ${errors.join('\n')}`);
    },
    close: () => browser.close(),
  };
}

export function launchChromium(): Promise<Browser> {
  const executablePath = findChromium();
  if (!executablePath)
    throw new Error('Chromium is not there: apt-get install -y chromium, or set CHROMIUM to its path');
  return chromium.launch({ executablePath, args: [...SOFTWARE_GPU_FLAGS] });
}

async function bundle(entry: string): Promise<string> {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    // A single bundle, because the page has no URL to load more from.
    build: {
      write: false,
      target: 'esnext',
      lib: { entry, formats: ['es'] },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  const output = Array.isArray(result) ? result[0] : result;
  if (!('output' in output)) throw new Error('vite gave a watcher instead of a bundle');
  return output.output[0].code;
}
