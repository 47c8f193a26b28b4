import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { decode } from 'fast-png';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import type { ParamValue } from '../../src/graph/document/document.ts';
import { parseDocument } from '../../src/graph/document/parse.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { applyCommand } from '../../src/graph/edits/commands.ts';
import { slowlight } from '../cli/program.ts';
import { colorCount, type MonitoredPage, Program, shots } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const [WIDTH, HEIGHT] = [192, 108];

/** A parameter for page and command line, and its value as the command line writes it. */
type Set = readonly [node: string, param: string, value: ParamValue, text: string];

/**
 * Makes the page, but not its renderer, assume a GPU: without one the page draws coarser shadows and one sample. The renderer's own canvas
 * keeps its name, for the command line filters textures as its device does.
 */
const asOnGpu = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const of = WebGL2RenderingContext.prototype;
    const { getParameter } = of;
    of.getParameter = function (name) {
      const probed = this.canvas instanceof HTMLCanvasElement && !this.canvas.isConnected;
      return probed && name === 0x9246 /* UNMASKED_RENDERER_WEBGL */ ? 'a GPU' : getParameter.call(this, name);
    };
  });

const example = (name: string): string => new URL(`../../examples/${name}.slowlight.json`, import.meta.url).pathname;

async function shown(name: string, backend: string, sets: readonly Set[]): Promise<MonitoredPage> {
  const commands = sets.map(([node, param, value]) => ({ kind: 'set-param', node, param, value }) as const);
  const { document } = applyCommand(parseDocument(readFileSync(example(name), 'utf8')), { kind: 'batch', commands });
  const address = `examples/${name}.slowlight.json`;
  const visit = await program.open(`?backend=${backend}&project=${address}`, {}, async (page) => {
    await asOnGpu(page);
    await page.route(`**/${address}`, (route) => route.fulfill({ body: serializeDocument(document) }));
  });
  const content = `.sl-picture { inline-size: ${WIDTH}px; block-size: ${HEIGHT}px; }`;
  await visit.page.addStyleTag({ content });
  // Of a captured picture no triangles are drawn.
  return name === 'captured' ? visit.finest() : visit.ready();
}

/** Fractions of the channels that differ, and that differ by more than one 8-bit step. */
function differing(a: Uint8Array, b: Uint8Array): readonly [some: number, more: number] {
  const steps = a.map((value, i) => Math.abs(value - b[i]!));
  const fraction = (least: number) => steps.filter((step) => step >= least).length / steps.length;
  return a.length === b.length ? [fraction(1), fraction(2)] : [1, 1];
}

function rgbOf(file: string): Uint8Array {
  const { data, channels } = decode(readFileSync(file));
  return Uint8Array.from(data.filter((_, i) => i % channels < 3));
}

const UNSMOOTHED = (node: string): Set => [node, 'antialiasing', false, 'off'];

it.each([
  ['webgl', 'plain', 8, []],
  ['webgl', 'layers', 1, [UNSMOOTHED('seen')]],
  ['webgl', 'captured', 1, [UNSMOOTHED('rasterize')]],
  ['webgl', 'rush', 1, [['falseColour', 'of', 'doppler', 'doppler']]],
  ['webgpu', 'plain', 1, [UNSMOOTHED('rasterize')]],
] as const)('on %s the page and the command line make the same picture of %s', async (backend, name, samples, sets) => {
  const file = join(shots, `alike-${backend}-${name}.png`);
  const flags = sets.flatMap(([node, param, _, text]) => ['--set', `${node}.${param}=${text}`]);
  const sampled = samples > 1 ? ['--samples', String(samples)] : [];
  const how = ['--size', `${WIDTH}x${HEIGHT}`, '--backend', backend];
  const { code, err } = await slowlight('render', example(name), '-o', file, ...flags, ...sampled, ...how);
  expect(code, err).toBe(0);
  const expected = rgbOf(file);
  const visit = await shown(name, backend, sets);
  // Wait until metering, tessellation and accumulation are complete.
  await expect.poll(async () => differing(await visit.pixels(), expected)).toEqual([0, 0]);
  expect(colorCount(expected)).toBeGreaterThan(50);
  await visit.close();
});

it('a flight that is recorded in the page is rendered by the command line to the same pixels', async () => {
  const visit = await shown('plain', 'webgl', []);
  const { page } = visit;
  await visit.viewport.focus();
  await page.keyboard.press('t');
  await page.keyboard.press('t');
  await page.getByRole('button', { name: 'Flight: Thrust' }).waitFor();
  // The project begins in motion.
  const begin = await visit.speed();
  await page.keyboard.press('k');
  for (const key of ['w', 'd', 'ArrowLeft', ',']) await page.keyboard.down(key);
  await expect.poll(async () => Math.abs((await visit.speed()) - begin)).toBeGreaterThan(0.1);
  // Instruments lag behind: what they show may be from before the recording.
  await visit.ticked();
  for (const key of ['w', 'd', 'ArrowLeft', ',']) await page.keyboard.up(key);
  await page.keyboard.press('k');
  await page.getByRole('button', { name: /^Flight: / }).click();
  await page.getByRole('slider', { name: 'Time of the flight' }).focus();
  await page.keyboard.press('End');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save the flight' }).click(),
  ]);
  const flight = join(shots, 'page.flight.json');
  await download.saveAs(flight);
  await page.keyboard.press('Escape');

  const inspected = await slowlight('flight', 'inspect', flight, '--json');
  const { pilotTime, legs } = JSON.parse(inspected.out);
  expect(legs.at(-1).gamma).toBeGreaterThan(1.004);
  const file = join(shots, 'flown.png');
  const how = ['--size', `${WIDTH}x${HEIGHT}`, '--backend', 'webgl', '--samples', '8'];
  const time = ['--flight', flight, '--time', String(pilotTime)];
  const { code, err } = await slowlight('render', example('plain'), '-o', file, ...time, ...how);
  expect(code, err).toBe(0);
  const expected = rgbOf(file);
  await expect.poll(async () => differing(await visit.pixels(), expected)).toEqual([0, 0]);
  expect(colorCount(expected)).toBeGreaterThan(50);
  await visit.close();
});

it('the headless page reports its device’s maximum size before rendering', async () => {
  const visit = await program.open('headless.html', {}, async (page) => {
    await page.addInitScript(() => {
      const of = WebGL2RenderingContext.prototype;
      const { getParameter } = of;
      of.getParameter = function (name) {
        return name === of.MAX_TEXTURE_SIZE ? 4321 : getParameter.call(this, name);
      };
    });
  });
  const started = await visit.page.evaluate(() => window.slowlight.start('raster'));
  expect(started.largest).toBe(4321);
  expect(started.adapterName).not.toBe('');
  await visit.close();
});
