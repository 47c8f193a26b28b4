import { afterAll, beforeAll, expect, it } from 'vitest';
import { Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

it('I tells of the point under the pointer: a ball at 0.5 c, by closed forms', async () => {
  const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc')).ready();
  const { page } = visit;
  await visit.viewport.hover();
  await visit.viewport.focus();
  await page.keyboard.press('i');
  const card = page.locator('[data-inspection]');
  await expect.poll(() => card.textContent()).toContain('/World/HalfLight');
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
  await visit.close();
});
