import { readFileSync } from 'node:fs';
import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { Program } from './program.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const options = { viewport: { width: 1100, height: 900 } };

it('a live spacetime diagram follows the observer, who is moved in it by keys, pointer and slider', async () => {
  const visit = await (await program.open('?backend=webgl&scene=examples/ladder.usdc', options)).ready();
  const { page } = visit;
  await page.getByRole('tab', { name: 'Diagram' }).click();
  const event = page.getByRole('slider', { name: 'Observer’s event in the diagram' });
  const svg = event.locator('svg');
  await svg.waitFor();
  expect(await svg.locator('title').first().textContent()).toBe('Spacetime diagram');
  const picture = () => svg.evaluate((element) => element.outerHTML);
  if (await page.getByRole('button', { name: 'Pause' }).isVisible())
    await page.getByRole('button', { name: 'Pause' }).click();

  const time = async () => Number((await event.getAttribute('aria-valuenow')) ?? Number.NaN);
  const before = await time();
  await event.press('ArrowUp');
  await expect.poll(time).toBeGreaterThan(before);
  const later = await time();
  // The picture follows the pointer: what lies in the future comes down to the observer.
  const { x, y, width } = (await event.boundingBox())!;
  await page.mouse.move(x + width / 2, y + 80);
  await page.mouse.down();
  await page.mouse.move(x + width / 2, y + 140, { steps: 4 });
  await page.mouse.up();
  await expect.poll(time).toBeGreaterThan(later);

  const drawn = await picture();
  const beta = page.getByRole('slider', { name: 'Observer’s velocity' });
  await beta.press('Home');
  await expect.poll(async () => (await svg.locator('desc').textContent()) ?? '').toContain('β = 0.99');
  expect(await picture()).not.toBe(drawn);
  await page.getByText('Observer’s frame').click();
  await expect.poll(async () => (await svg.locator('desc').textContent()) ?? '').toContain('rest frame');
  await visit.shot('diagram');
  expect((await new AxeBuilder({ page }).analyze()).violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual(
    [],
  );

  const saved = async (name: string) => {
    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name }).click()]);
    return readFileSync(await file.path());
  };
  expect((await saved('Save SVG')).toString()).toMatch(/^<svg [^>]*width="1200" height="800"/);
  const png = await saved('Save PNG');
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([2400, 1600]);

  await page.getByText('Energy over β').click();
  await page.getByText('Momentum / mc').first().waitFor();
  await page.getByText('Objects: ').click();
  await page.getByLabel('/World/Ladder').waitFor();
  expect((await new AxeBuilder({ page }).analyze()).violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual(
    [],
  );
  await visit.shot('diagram-energy');
  await visit.close();
});
