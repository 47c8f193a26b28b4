import { afterAll, beforeAll, expect, it } from 'vitest';
import { Program, sharedPage } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());
const opened = sharedPage(async () => (await program.open('?backend=webgl&scene=examples/sphere.usdc')).ready());

it('I tells of the point under the pointer: a ball at 0.5 c, by closed forms', async () => {
  const visit = await opened();
  const { page } = visit;
  await visit.viewport.hover();
  await visit.viewport.focus();
  await page.keyboard.press('i');
  const card = page.locator('[data-inspection]');
  await expect.poll(() => card.textContent()).toContain('/World/Half');
  const figure = async (title: string): Promise<number> => {
    const text = await card.locator('dt', { hasText: title }).locator('xpath=following-sibling::dd[1]').textContent();
    return Number(/[\d.]+/.exec(text ?? '')?.[0]);
  };
  const approach = await figure('Seems to approach');
  expect(await figure('Velocity')).toBeCloseTo(0.5, 3);
  // With k = 1/(1 − β cos θ): β cos θ k approaching, so that k = 1 + that; D = k/γ; β sin θ k across.
  const k = 1 + approach;
  expect(await figure('Doppler factor D')).toBeCloseTo(k * Math.sqrt(0.75), 1);
  expect(await figure('Seems to move across')).toBeCloseTo(Math.sqrt((0.5 * k) ** 2 - approach ** 2), 2);
  await visit.shot('inspect');
  await page.keyboard.press('i');
  await card.waitFor({ state: 'detached' });
});

it('M measures between two points: of a ball at 0.5 c what is seen, what is now, and what it is at rest', async () => {
  const visit = await opened();
  const { page } = visit;
  await visit.viewport.focus();
  await page.keyboard.press('m');
  const card = page.locator('[data-inspection]');
  await expect.poll(() => card.textContent()).toContain('Choose a point');
  const box = (await visit.viewport.boundingBox())!;
  const click = (dx: number) => page.mouse.click(box.x + box.width / 2 + dx, box.y + box.height / 2);
  await click(40);
  await expect.poll(() => card.textContent()).toContain('Choose the other point');
  await click(90);
  await expect.poll(() => card.textContent()).toContain('Rest length');
  const length = async (title: string): Promise<number> => {
    const text = await card.locator('dt', { hasText: title }).locator('xpath=following-sibling::dd[1]').textContent();
    return Number(/^([\d.]+)\smm/.exec(text ?? '')?.[1]);
  };
  const [slice, rest] = [await length('Length at your moment'), await length('Rest length')];
  // It is contracted by γ along its motion, and not across.
  expect(slice).toBeGreaterThan(rest * Math.sqrt(0.75) * 0.99);
  expect(slice).toBeLessThan(rest * 1.01);
  await visit.shot('measure');
  await page.keyboard.press('Escape');
  await card.waitFor({ state: 'detached' });
});
