import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type MonitoredPage, Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** At 0.5 c, looking ahead at a sphere at rest. */
const MOVING = '?backend=webgl&scene=examples/sphere.usdc';
/** At rest, among balls and rods at rest. */
const RESTING = '?backend=webgl&scene=examples/lattice.usdc';

const card = (visit: MonitoredPage) => visit.page.locator('[data-inspection]');
const spoken = (visit: MonitoredPage) => visit.page.locator('[data-spoken]');
/** The number in the row with this title. */
const figure = async (visit: MonitoredPage, title: string): Promise<number> => {
  const text = await card(visit)
    .locator('dt', { hasText: title })
    .locator('xpath=following-sibling::dd[1]')
    .textContent();
  return Number(/[\d.]+/.exec((text ?? '').replaceAll('\u202f', ''))?.[0]);
};
const pointAt = async (visit: MonitoredPage, x: number, y: number) => {
  const box = (await visit.viewport.boundingBox())!;
  return [box.x + x * box.width, box.y + y * box.height] as const;
};
async function seriousViolations(visit: MonitoredPage): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page: visit.page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
}

describe('inspecting', () => {
  it('tells of the point under the pointer what closed forms say, at 0.5 c straight ahead', async () => {
    const visit = await (await program.open(MOVING, { viewport: { width: 1280, height: 720 } })).ready();
    await visit.viewport.focus();
    await visit.page.mouse.move(...(await pointAt(visit, 0.5, 0.5)));
    await visit.page.keyboard.press('i');
    await expect.poll(() => card(visit).locator('dt').count()).toBeGreaterThan(8);
    const beta = await visit.speed();
    expect(await figure(visit, 'Relative to you')).toBeCloseTo(beta, 2);
    expect(await figure(visit, 'Doppler factor D')).toBeCloseTo(Math.sqrt((1 + beta) / (1 - beta)), 1);
    expect(await figure(visit, 'Seems to approach')).toBeCloseTo(beta / (1 - beta), 1);
    expect(await figure(visit, 'Looks turned by')).toBeLessThan(1);
    const [then, now] = [await figure(visit, 'Distance then'), await figure(visit, 'Distance now')];
    // Light that left it D r away, r/γ from the moment: (1 + β)γ and 1/γ of the same distance.
    expect(then / now).toBeCloseTo((1 + beta) / (1 - beta * beta), 1);
    await visit.shot('inspect-pointer');
    // It follows the pointer, out to the sky.
    await visit.page.mouse.move(...(await pointAt(visit, 0.02, 0.02)));
    await expect.poll(() => card(visit).textContent()).toContain('sky');
    await visit.page.keyboard.press('i');
    await card(visit).waitFor({ state: 'detached' });
    await visit.close();
  });

  it('works by keyboard, is read aloud, and ends with Escape, in English and Chinese', async () => {
    const visit = await (await program.open(MOVING)).ready();
    await visit.viewport.focus();
    await visit.page.keyboard.press('i');
    await expect.poll(() => card(visit).locator('dt').count()).toBeGreaterThan(8);
    await visit.page.locator('.sl-crosshair').waitFor();
    await expect.poll(() => spoken(visit).textContent()).toMatch(/away when its light left/);
    await visit.shot('inspect-keys');
    expect(await seriousViolations(visit)).toEqual([]);
    await visit.page.keyboard.press('Escape');
    await card(visit).waitFor({ state: 'detached' });
    // Only the tool was put away: keys still go to the picture.
    await visit.page.keyboard.press('m');
    await card(visit).getByText('press Enter').waitFor();
    await visit.chooseLanguage('中文');
    await card(visit).getByText('选取一点').waitFor();
    await visit.viewport.focus();
    await visit.page.keyboard.press('i');
    await card(visit).getByText('多普勒因子').waitFor();
    await visit.shot('inspect-chinese');
    await visit.close();
  });
});

describe('measuring', () => {
  it('gives three lengths that agree where all is at rest, by two clicks', async () => {
    const visit = await (await program.open(RESTING, { viewport: { width: 1280, height: 720 } })).ready();
    await visit.viewport.focus();
    await visit.page.keyboard.press('m');
    await card(visit).getByText('Choose a point').waitFor();
    await visit.page.mouse.click(...(await pointAt(visit, 0.5, 0.5)));
    await card(visit).getByText('Choose the other point').waitFor();
    await visit.page.keyboard.press('Enter');
    await visit.page.locator('.sl-measure line').waitFor({ state: 'attached' });
    await visit.shot('measure-clicks');
    const lengths = async () => {
      const titles = ['Apparent length', 'Length at your moment', 'Rest length'];
      return Promise.all(titles.map((title) => figure(visit, title)));
    };
    const [apparent, slice, rest] = await lengths();
    expect(apparent).toBe(rest);
    expect(slice).toBe(rest);
    await visit.page.keyboard.press('Escape');
    await card(visit).waitFor({ state: 'detached' });
    await visit.close();
  });

  it('of the two edges of a sphere ahead of one who flies: by Enter and a click, drawn as a line between them', async () => {
    const visit = await (await program.open(MOVING, { viewport: { width: 1280, height: 720 } })).ready();
    await visit.viewport.focus();
    await visit.page.keyboard.press('m');
    await visit.page.keyboard.press('Enter');
    await card(visit).getByText('Choose the other point').waitFor();
    await visit.page.mouse.click(...(await pointAt(visit, 0.52, 0.5)));
    const line = visit.page.locator('.sl-measure line');
    await line.waitFor({ state: 'attached' });
    const ends = async () =>
      Promise.all(['x1', 'y1', 'x2', 'y2'].map(async (name) => Number.parseFloat((await line.getAttribute(name))!)));
    for (const [i, share] of [50, 50, 52, 50].entries()) expect(Math.abs((await ends())[i]! - share)).toBeLessThan(1);
    expect(await figure(visit, 'Rest length')).toBeGreaterThan(0);
    expect(await seriousViolations(visit)).toEqual([]);
    await visit.shot('measure-sphere');
    await visit.close();
  });
});
