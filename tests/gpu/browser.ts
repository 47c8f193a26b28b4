import { type Browser, chromium, type Page } from 'playwright-core';
import { build } from 'vite';
import { findChromium } from '../../src/cli/icd.ts';

/** WebGPU on SwiftShader and WebGL2 on Mesa's llvmpipe, without a window and without a GPU; a real GPU is used where there is one. */
const FLAGS = [
  '--headless',
  '--no-sandbox',
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--use-gl=angle',
  '--use-angle=gl-egl',
  '--ignore-gpu-blocklist',
];

/** A page with one module of this repository in it. */
export interface ModulePage {
  readonly page: Page;
  /** Throws what the page has thrown or logged as an error since it was opened. */
  assertHealthy(): void;
  close(): Promise<void>;
}

/** Bundles `entry` (an absolute path) and opens it in Chromium; what it puts on `window` can be called through `page`. */
export async function openModulePage(entry: string): Promise<ModulePage> {
  const [code, browser] = await Promise.all([bundle(entry), launchChromium()]);
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  await page.setContent('<!doctype html><title>Slowlight: shader tests</title>');
  await page.addScriptTag({ content: code, type: 'module' });
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
  return chromium.launch({ executablePath, args: FLAGS });
}

async function bundle(entry: string): Promise<string> {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    build: { write: false, target: 'esnext', lib: { entry, formats: ['es'] } },
  });
  const output = Array.isArray(result) ? result[0] : result;
  if (!('output' in output)) throw new Error('vite gave a watcher instead of a bundle');
  return output.output[0].code;
}
