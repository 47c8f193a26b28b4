import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const violations = async (page: Page) =>
  (await new AxeBuilder({ page }).analyze()).violations.map(({ id, nodes }) => [id, nodes[0]?.html]);

it('a link opens a step; its question is answered by keyboard, then seen; it prints whole, in both languages', async () => {
  const options = { viewport: { width: 1280, height: 800 } };
  const visit = await (await program.open('?backend=webgl&lesson=aberration&step=2', options)).ready();
  const { page } = visit;
  const panel = page.locator('[data-lessons]');
  await panel.getByRole('heading', { name: 'The same place at 0.9 c' }).waitFor();
  expect(await panel.textContent()).toContain('Step 2 of 5');
  const speed = () => visit.status('speed');
  const before = await speed();
  const see = panel.getByRole('button', { name: 'See' });
  expect(await see.isDisabled()).toBe(true);

  const answers = panel.getByRole('radio');
  await answers.first().focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('ArrowDown');
  expect(await answers.nth(1).isChecked()).toBe(true);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await panel.getByRole('status').getByText('Right.').waitFor();
  await expect.poll(speed).toContain('0.9');
  expect(before).not.toContain('0.9');
  await answers.first().check();
  await panel.getByRole('status').getByText('Not so.').waitFor();
  await visit.shot('lesson');
  expect(await violations(page)).toEqual([]);

  await panel.getByRole('button', { name: 'Next' }).press('Enter');
  const heading = panel.getByRole('heading', { name: 'How far a star moves' });
  await expect.poll(() => heading.evaluate((element) => element === document.activeElement)).toBe(true);
  await expect.poll(() => page.title()).toContain('starfield');
  // It may hold the answer.
  expect(await page.locator('.sl-caption').count()).toBe(0);
  await page.getByRole('button', { name: /^Undo/ }).click();
  await expect.poll(() => page.title()).toContain('street');

  await page.emulateMedia({ media: 'print' });
  const printed = page.locator('.sl-lesson-print');
  expect(await printed.isVisible()).toBe(true);
  expect(await page.locator('#root').isVisible()).toBe(false);
  expect(await printed.locator('section > h2').count()).toBe(6);
  await page.emulateMedia({ media: 'screen' });
  expect(await printed.isVisible()).toBe(false);

  await visit.chooseLanguage('中文');
  await panel.getByRole('heading', { name: '一颗星移动多远' }).waitFor();
  await visit.close();
});

it('a step flies, with the panel that it speaks of; answers outlast a reload', async () => {
  const address = '?backend=webgl&lesson=twins&step=2';
  // A small picture, which is drawn often enough even without a graphics card.
  const options = { viewport: { width: 1100, height: 480 }, reducedMotion: 'no-preference' } as const;
  const visit = await (await program.open(address, options)).ready();
  const { page } = visit;
  const panel = page.locator('[data-lessons]');
  const readings = () => page.locator('.sl-clocks tbody').first().locator('td').first().textContent();
  await expect.poll(readings).toContain('0.00 s');
  await panel.getByRole('radio').last().check();
  await panel.getByRole('button', { name: 'See' }).click();
  // The flight takes 8 s by its own clock, at whatever rate the page draws; then it stands still at the turn.
  await expect.poll(readings).toContain('8.00 s');
  expect(await visit.status('speed')).toContain('0.6');
  const home = page.locator('.sl-clocks tbody').filter({ hasText: '/World/Home' }).locator('td');
  expect(await home.allTextContents()).toEqual([
    expect.stringContaining('4.00 s'),
    expect.stringContaining('6.40 s'),
    expect.stringContaining('10.00 s'),
  ]);

  await page.reload();
  await visit.ready();
  await panel.getByRole('status').getByText('Right.').waitFor();
  expect(await panel.getByRole('radio').last().isChecked()).toBe(true);
  await panel.getByRole('button', { name: 'Start again' }).click();
  await panel.getByRole('heading', { name: 'Two dials' }).waitFor();
  await panel.getByRole('button', { name: 'Next' }).click();
  await expect.poll(() => panel.getByRole('radio').last().isChecked()).toBe(false);
  await visit.close();
});

it('the list opens from the gallery; wrong links are told; on a narrow page lessons are a tab', async () => {
  const visit = await (
    await program.open('?backend=webgl&lesson=nothing', { viewport: { width: 360, height: 780 } })
  ).ready();
  const { page } = visit;
  const notice = page.getByRole('alert').filter({ hasText: 'The link asks for the lesson “nothing”' });
  await notice.waitFor();
  const panel = page.locator('[data-lessons]');
  await panel.locator('[data-lesson="doppler"]').waitFor();
  expect(await violations(page)).toEqual([]);
  // On so narrow a page it lies over dialogues.
  await notice.getByRole('button', { name: 'Close' }).click();
  await panel.getByRole('button', { name: 'Close lessons' }).click();
  await expect.poll(() => panel.count()).toBe(0);
  await page.getByRole('button', { name: 'Scenes' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Lessons' }).click();
  await panel.locator('[data-lesson="terrell"]').click();
  await panel.getByRole('heading', { name: 'Dice at rest' }).waitFor();
  await expect.poll(() => page.title()).toContain('dice');
  await visit.settled();
  await visit.shot('lesson-narrow');
  await visit.close();
});
