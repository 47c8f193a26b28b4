import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { type DecodedPng, decode } from 'fast-png';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { OVERLAY_COLORS } from '../../src/spectrum/display/overlayColors.ts';
import { encodeSrgb } from '../../src/spectrum/display/srgb.ts';
import { colorAt } from '../../src/spectrum/falseColor/falseColor.ts';
import { type MonitoredPage, Program, shots } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** A ball passing at 0.5 c. */
const MOVING = '?backend=webgl&scene=examples/sphere.usdc';
const WIDTH = 1000;

async function save(visit: MonitoredPage, name: string): Promise<DecodedPng> {
  const download = visit.page.waitForEvent('download');
  await visit.page.keyboard.press('Control+Shift+s');
  const file = join(shots, `${name}.png`);
  await (await download).saveAs(file);
  return decode(readFileSync(file), { checkCrc: true });
}

type Rgb = readonly [number, number, number];
const at = ({ data, width, channels }: DecodedPng, x: number, y: number): Rgb => {
  const i = channels * (Math.round(y) * width + Math.round(x));
  return [data[i]!, data[i + 1]!, data[i + 2]!];
};

/** Number of differing pixels inside and outside of a box. */
function differing(a: DecodedPng, b: DecodedPng, { x, y, width, height }: Box): { inside: number; outside: number } {
  const count = { inside: 0, outside: 0 };
  for (let row = 0; row < a.height; row++)
    for (let column = 0; column < a.width; column++) {
      if (at(a, column, row).every((value, k) => value === at(b, column, row)[k])) continue;
      const isInside = column >= x - 1 && column <= x + width && row >= y - 1 && row <= y + height;
      count[isInside ? 'inside' : 'outside']++;
    }
  return count;
}
type Box = { x: number; y: number; width: number; height: number };

function pixelsIn(picture: DecodedPng, { x, y, width, height }: Box): readonly Rgb[] {
  const [columns, rows] = [Math.floor(width), Math.floor(height)];
  return Array.from({ length: columns * rows }, (_, i) => at(picture, x + (i % columns), y + Math.floor(i / columns)));
}

it('a saved picture has the displayed legend, at its place, and metadata', async () => {
  const visit = await (await program.open(MOVING, { viewport: { width: WIDTH, height: 600 } })).ready();
  const plain = await save(visit, 'saved-light');
  expect(plain.text).toMatchObject({
    Software: 'Slowlight',
    view: 'light-cone',
    observerSpeed: '0 c',
    tone: 'neutral',
  });
  expect(plain.text?.exposure).toMatch(/^-?[\d.]+ EV$/);

  await visit.viewport.focus();
  await visit.page.keyboard.press('x');
  const legend = visit.page.locator('[data-legend]');
  await legend.waitFor();
  await visit.settled();
  const [box, under] = [(await legend.boundingBox())!, (await visit.viewport.boundingBox())!];
  const place = { ...box, x: box.x - under.x, y: box.y - under.y };
  const bar = (await visit.page.locator('.sl-legend-bar').boundingBox())!;
  const withLegend = await save(visit, 'saved-legend');
  await visit.page.getByRole('button', { name: 'Hide', exact: true }).first().click();
  await legend.waitFor({ state: 'detached' });
  const without = await save(visit, 'saved-no-legend');

  const { inside, outside } = differing(withLegend, without, place);
  expect(outside).toBe(0);
  expect(inside).toBeGreaterThan(0.5 * place.width * place.height);
  const [from, to] = /doppler from ([\d.e-]+) to ([\d.e-]+)/
    .exec(withLegend.text?.falseColors ?? '')!
    .slice(1)
    .map(Number);
  expect(withLegend.text?.exposure).toBeUndefined();
  for (const part of [0.1, 0.3, 0.5, 0.7, 0.9]) {
    const shown = at(withLegend, bar.x - under.x + part * bar.width, bar.y - under.y + bar.height / 2);
    colorAt('doppler', part, { from: from!, to: to! }).forEach((value, k) => {
      expect(Math.abs(value - shown[k]!)).toBeLessThanOrEqual(6);
    });
  }
  await visit.close();
});

it('a saved picture has the displayed legend of a ghost, and of past and future, at its place', async () => {
  const visit = await (await program.open(MOVING, { viewport: { width: WIDTH, height: 600 } })).ready();
  await visit.page.getByRole('combobox', { name: 'Ghost' }).click();
  await visit.page.getByRole('option', { name: 'Simultaneity' }).click();
  await visit.page.getByRole('switch', { name: 'Past and future' }).press('Space');
  const legend = visit.page.locator('[data-overlay-legend]');
  await legend.getByText('Future').waitFor();
  await visit.finest();
  const under = (await visit.viewport.boundingBox())!;
  const boxOf = async (part: typeof legend): Promise<Box> => {
    const box = (await part.boundingBox())!;
    return { ...box, x: box.x - under.x, y: box.y - under.y };
  };
  const picture = await save(visit, 'saved-overlay-legend');
  // Each sign has its colour, and the text beside it is there.
  for (const [mark, linear] of Object.entries(OVERLAY_COLORS)) {
    const row = legend.locator('li', { has: visit.page.locator(`[data-mark=${mark}]`) });
    const sign = await boxOf(row.locator('[data-mark]'));
    const color = linear.map((x) => Math.round(255 * encodeSrgb(x)));
    const near = pixelsIn(picture, sign).filter((pixel) => pixel.every((x, k) => Math.abs(x - color[k]!) < 30));
    expect(near.length, mark).toBeGreaterThan(0.1 * sign.width * sign.height);
    const text = pixelsIn(picture, await boxOf(row.locator(':scope > :last-child')));
    expect(new Set(text.map(String)).size, mark).toBeGreaterThan(10);
  }
  await visit.close();
});

it('the value at the crosshair is saved with it, also in Chinese and at double resolution; a hidden legend stays hidden', async () => {
  const options = { viewport: { width: WIDTH, height: 600 }, deviceScaleFactor: 2, locale: 'zh-CN' };
  const visit = await (await program.open(MOVING, options)).ready();
  await visit.viewport.focus();
  for (let i = 0; i < 4; i++) await visit.page.keyboard.press('x');
  await visit.page.keyboard.press('p');
  await visit.page.locator('[data-reading] b').waitFor();
  await visit.settled();
  const picture = await save(visit, 'saved-crosshair-zh');
  expect(picture.width).toBe(2 * Math.round((await visit.viewport.boundingBox())!.width));
  expect(at(picture, picture.width / 2 - 12, picture.height / 2)).toEqual([255, 255, 255]);
  expect(picture.text?.falseColors).toMatch(/^band from 3e-8 m to/);

  await visit.page.getByRole('button', { name: '隐藏' }).first().click();
  await visit.page.reload();
  await visit.ready();
  await visit.viewport.focus();
  await visit.page.getByRole('button', { name: '图例' }).waitFor();
  expect(await visit.page.locator('[data-legend]').count()).toBe(0);
  await visit.page.keyboard.press('p');
  await visit.page.locator('[data-legend]').waitFor();
  await visit.close();
});
