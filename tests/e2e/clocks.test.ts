import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';
import { drop } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** A ball that recedes at 0.5 c from the observer, with whom it was at −3 s, and one that crosses 60 m before him at −8 s. */
const RECEDING = `#usda 1.0
( customLayerData = { dictionary slowlight = { double speedOfLight = 10 } }
  metersPerUnit = 1
  upAxis = "Y" )
def Camera "Eye"
{
    float focalLength = 10
    float verticalAperture = 20
}
def Sphere "Ball"
{
    double3 xformOp:translate = (0, 0, -15)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    uniform token slowlight:motion = "uniform"
    vector3d slowlight:velocity = (0, 0, -5)
}
def Sphere "Other"
{
    double3 xformOp:translate = (40, 0, -60)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    uniform token slowlight:motion = "uniform"
    vector3d slowlight:velocity = (5, 0, 0)
}
def Cube "Wall"
{
    double3 xformOp:translate = (-10, 0, -20)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def Sphere "Hidden"
{
    double3 xformOp:translate = (-20, 0, -40)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def Cube "Post"
{
    double3 xformOp:translate = (0, 3, -20)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
`;

/** Opens the panel by keys alone. */
async function clocksPanel(locale: string, tab: string): Promise<MonitoredPage> {
  const options = { viewport: { width: 1100, height: 900 }, locale };
  const visit = await (await program.open('?backend=webgl&scene=examples/boxes.usdc', options)).ready();
  await drop(visit, [{ name: 'receding.usda', content: Buffer.from(RECEDING) }]);
  await visit.page.getByRole('tab', { name: tab }).focus();
  await visit.page.keyboard.press('Enter');
  await visit.page.locator('.sl-clocks-name', { hasText: '/Ball' }).waitFor();
  return visit;
}

const violations = async ({ page }: MonitoredPage) =>
  (await new AxeBuilder({ page }).analyze()).violations.map(({ id, nodes }) => [id, nodes[0]?.html]);

it('shows clocks as they are seen and as they are, and compares events that are marked', async () => {
  const visit = await clocksPanel('en-GB', 'Clocks');
  const { page } = visit;
  const cells = async (name: string): Promise<string[]> =>
    page.locator('tbody', { hasText: name }).first().locator('td').allTextContents();
  const numbers = (texts: readonly string[]) => texts.map((text) => Number.parseFloat(text.replace('−', '-')));
  // A dropped scene begins at its own start, a moment after its objects are named.
  const t = 0;
  await expect.poll(async () => numbers(await cells('World'))[2]).toBe(t);
  const ball = await cells('/Ball');
  const [seen, slice, world] = numbers(ball) as [number, number, number];
  // 5 (t_e + 3) = 10 (t − t_e), and γ = 2/√3; 1/√3 and √3/2 are its rates.
  expect(seen).toBeCloseTo((Math.sqrt(0.75) * (2 * t - 3)) / 3, 1);
  expect([slice, world]).toEqual([expect.closeTo(Math.sqrt(0.75) * t, 1), slice]);
  expect(ball.map((text) => text.replace(/^.* s/, ''))).toEqual(['D 0.577', '× 0.866', '× 0.866']);

  await page.getByRole('switch', { name: 'Show them in the picture' }).press('Space');
  const label = page.locator('[data-clock="/Other"]');
  await label.locator('b').waitFor();
  // 10 (t − s) = √(60² + (40 + 5s)²): its light left at s. The picture is 2 high at distance 1.
  const s = (20 * t + 40 - Math.sqrt((20 * t + 40) ** 2 - 3 * (100 * t ** 2 - 5200))) / 15;
  const picture = (await visit.viewport.boundingBox())!;
  const point = (await label.locator('i').boundingBox())!;
  const across = picture.width / 2 + (((40 + 5 * s) / 60) * picture.height) / 2;
  expect(Math.abs(point.x + point.width / 2 - picture.x - across)).toBeLessThan(3);
  expect(Math.abs(point.y + point.height / 2 - picture.y - picture.height / 2)).toBeLessThan(1);
  expect(await label.textContent()).toMatch(/^Other −?\d+\.\d\d s$/);
  expect(numbers([(await label.locator('b').textContent())!])[0]).toBeCloseTo(Math.sqrt(0.75) * s, 1);

  await page.getByRole('button', { name: 'Mark: /Ball' }).press('Enter');
  await page.getByRole('button', { name: 'Mark: Ship' }).press('Enter');
  await page.getByText('lightlike: light goes from one to the other').waitFor();
  await page.getByRole('button', { name: 'Mark: Ship' }).press('Enter');
  await page.getByRole('button', { name: 'Remove: 2' }).press('Enter');
  await expect.poll(() => page.getByRole('button', { name: /^Remove: \d$/ }).count()).toBe(2);

  // A name is kept in the project: it is unlike the others, and there after a reload.
  const name = (of: string) => page.getByRole('textbox', { name: `Name of the event ${of}`, exact: true });
  await name('3').fill('arrival');
  await name('3').press('Enter');
  await name('arrival').waitFor();
  await name('1').fill('arrival');
  await page.getByText('Another event has this name').waitFor();
  expect(await name('1').getAttribute('aria-invalid')).toBe('true');
  expect(await violations(visit)).toEqual([]);
  await name('1').press('Enter');
  expect(await name('1').inputValue()).toBe('arrival');
  await name('1').press('Escape');
  expect(await name('1').inputValue()).toBe('1');
  expect(await name('1').getAttribute('aria-invalid')).toBe('false');
  expect(await visit.refusals.count()).toBe(0);

  const add = async (path: string) => {
    await page.getByRole('combobox', { name: 'Add the clock of an object' }).click();
    await page.getByRole('option', { name: path }).click();
  };
  // Behind the wall.
  await add('/Hidden');
  await page.locator('[data-clock="/Hidden"][data-behind] b').waitFor();
  expect(await page.locator('[data-behind]').count()).toBe(1);
  await add('/Post');
  expect((await cells('/Post')).map((text) => text.replace(/^.* s/, ''))).toEqual(['D 1.00', '× 1.00', '× 1.00']);
  await visit.shot('clocks');
  expect(await violations(visit)).toEqual([]);
  await page.getByRole('button', { name: 'Remove: /Ball' }).press('Enter');
  await expect.poll(() => page.locator('th[scope=rowgroup]').allTextContents()).not.toContain('/Ball⚑×');
  await page.reload();
  // The picture shows clocks again, before the panel is opened.
  await label.locator('b').waitFor();
  await page.getByRole('tab', { name: 'Clocks' }).press('Enter');
  await name('arrival').waitFor();
  await page.getByRole('switch', { name: 'Show them in the picture' }).press('Space');
  await label.waitFor({ state: 'detached' });
  await visit.close();
});

it('speaks Chinese', async () => {
  const visit = await clocksPanel('zh-CN', '时钟');
  await visit.page.getByRole('columnheader', { name: '同时面' }).waitFor();
  await visit.page.getByRole('button', { name: '标记：飞船' }).press('Enter');
  await visit.page.getByText('已标记的事件').waitFor();
  await visit.shot('clocks-zh');
  expect(await violations(visit)).toEqual([]);
  await visit.close();
});
