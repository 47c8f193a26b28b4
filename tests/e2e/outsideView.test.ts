import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { OBSERVER_MARKS } from '../../src/scene/frameGraph/effects.ts';
import { encodeSrgb } from '../../src/spectrum/display/srgb.ts';
import { type MonitoredPage, Program } from './program.ts';
import { drop } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** A ball 6 m before the observer, and one that passes at 0.5 c. */
const SCENE = `#usda 1.0
( customLayerData = { dictionary slowlight = { double speedOfLight = 10 } }
  metersPerUnit = 1
  upAxis = "Y" )
def Camera "Eye"
{
    double3 xformOp:translate = (0, 1, 0)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def Sphere "Passing"
{
    double3 xformOp:translate = (-3, 1, -4)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    uniform token slowlight:motion = "uniform"
    vector3d slowlight:velocity = (5, 0, 0)
}
def Sphere "Ball"
{
    double radius = 1.5
    double3 xformOp:translate = (0, 1, -6)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
`;

const centre = (page: Page) =>
  page.locator('.sl-outside canvas').evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const at = canvas.getContext('2d')!.getImageData(canvas.width >> 1, canvas.height >> 1, 1, 1).data;
    return Array.from(at.subarray(0, 3));
  });
const image = (page: Page) =>
  page.locator('.sl-outside canvas').evaluate((element) => (element as HTMLCanvasElement).toDataURL());
const body = OBSERVER_MARKS.body.map((value) => Math.round(255 * encodeSrgb(value)));
const drawn = ({ page }: MonitoredPage) => page.locator('.sl-outside canvas[data-drawn]').waitFor();

it('shows the observer in the world, live, and is turned by keys, wheel and drag', async () => {
  const visit = await (await program.open('?backend=webgl&scene=examples/boxes.usdc')).ready();
  const { page } = visit;
  await drop(visit, [{ name: 'outside.usda', content: Buffer.from(SCENE) }]);
  await visit.viewport.focus();
  await page.keyboard.press('o');
  await drawn(visit);
  // He is in the middle, whatever is behind him.
  await expect.poll(() => centre(page)).toEqual(body.map((value) => expect.closeTo(value, -0.5)));
  const outside = page.getByRole('region', { name: 'Outside view' });
  const changes = async (act: () => Promise<unknown>) => {
    const before = await image(page);
    await act();
    await expect.poll(() => image(page)).not.toBe(before);
    await expect.poll(() => centre(page)).toEqual(body.map((value) => expect.closeTo(value, -0.5)));
  };
  const picture = outside.getByRole('application');
  await picture.focus();
  await changes(() => page.keyboard.press('ArrowRight'));
  await changes(() => page.keyboard.press('+'));
  const box = (await picture.boundingBox())!;
  await page.mouse.move(box.x + 90, box.y + 40);
  await changes(() => page.mouse.wheel(0, 300));
  await changes(async () => {
    await page.mouse.down();
    await page.mouse.move(box.x + 40, box.y + 60, { steps: 4 });
    await page.mouse.up();
  });
  await changes(() => outside.getByText('What is seen', { exact: true }).click());
  await changes(() => outside.getByRole('switch').press('Space'));
  // It follows who moves.
  const before = await image(page);
  await visit.viewport.focus();
  await page.keyboard.down('w');
  await expect.poll(() => visit.speed()).toBeGreaterThan(0.3);
  await page.keyboard.up('w');
  await expect.poll(() => image(page)).not.toBe(before);
  await visit.shot('outside-view');
  const { violations } = await new AxeBuilder({ page }).include('.sl-outside').analyze();
  expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([]);
  await picture.focus();
  await page.keyboard.press('Escape');
  await outside.waitFor({ state: 'detached' });
  await visit.close();
});

it('speaks Chinese, and fits a narrow page', async () => {
  const options = { locale: 'zh-CN', viewport: { width: 390, height: 800 } };
  const visit = await (await program.open('?backend=webgl&scene=examples/boxes.usdc', options)).ready();
  await visit.viewport.focus();
  await visit.page.keyboard.press('o');
  await drawn(visit);
  const box = (await visit.page.getByRole('region', { name: '外部视图' }).boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(390);
  await visit.shot('outside-view-zh');
  await visit.close();
});
