import { AxeBuilder } from '@axe-core/playwright';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { hangingCloth } from '../../examples/projects/hangingCloth.ts';
import type { ParamValue } from '../../src/graph/document/document.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { colorCount, difference, type MonitoredPage, Program } from './program.ts';
import { drop } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const hanging = (params: Readonly<Record<string, ParamValue>>): string => {
  const set = Object.entries(params).map(
    ([param, value]): Command => ({ kind: 'set-param', node: 'swing', param, value }),
  );
  // A dropped project resolves files relative to the page, not to itself.
  const source = { kind: 'set-param', node: 'place', param: 'source', value: 'examples/sets/terrace.usdc' } as const;
  return serializeDocument(applyCommand(hangingCloth(), { kind: 'batch', commands: [source, ...set] }).document);
};
/** Long enough, with short enough steps, that no test reaches its end. */
const endless = hanging({ step: 4e-5, duration: 300 });

/** The panel's state of the run: the time computed so far [s]. */
async function computed({ page }: MonitoredPage): Promise<number> {
  const text = (await page.locator('.sl-energy tbody').textContent()) ?? '';
  return Number(/(?:until|stopped at) ([\d.]+) s/.exec(text)?.[1]);
}

it('a simulation is displayed with its energy while it is computed; it can be stopped, is kept, and resumes from there', async () => {
  const options = { viewport: { width: 1100, height: 760 } };
  const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc', options)).ready();
  const { page } = visit;
  const before = await (await visit.finest()).pixels();
  await drop(visit, [{ name: 'cloth.slowlight.json', content: Buffer.from(endless) }]);
  await page.getByRole('tab', { name: 'Energy' }).click();
  await expect.poll(() => computed(visit)).toBeGreaterThan(0.1);
  await page.getByText('Simulating').waitFor();

  // The cloth is shown at computed times, not only at its initial position.
  await expect.poll(async () => difference(await visit.pixels(), before)).toBeGreaterThan(5);
  const plot = page.getByRole('slider', { name: 'Change of energy over time' });
  await plot.press('Home');
  await expect.poll(() => visit.status('world-time')).toBe('t = 0.00 s');
  const level = await visit.pixels();
  expect(colorCount(level)).toBeGreaterThan(200);
  const shown = await computed(visit);
  await expect.poll(() => computed(visit)).toBeGreaterThan(shown + 0.1);
  await plot.press('End');
  await expect.poll(async () => difference(await visit.pixels(), level)).toBeGreaterThan(0.5);
  await visit.shot('simulation-runs');

  // Drag only removes energy, which is not drift.
  const cells = page.locator('.sl-energy tbody td');
  expect(await cells.nth(0).textContent()).toMatch(/^−[\d.]+$/);
  const drift = Number((await cells.nth(1).textContent())?.replace('−', '-'));
  expect(drift).toBeGreaterThan(0);
  expect(drift).toBeLessThan(0.01);
  await page.getByText(/drag took [\d.]+ J/).waitFor();
  expect(await cells.nth(2).textContent()).toMatch(/^0\.\d+ c$/);
  expect(await plot.getAttribute('aria-valuetext')).toMatch(/^[\d.]+ s: Leapfrog −[\d.]+ J$/);
  expect((await new AxeBuilder({ page }).include('.sl-energy').include('.sl-plot').analyze()).violations).toEqual([]);

  // By keyboard: the stop button becomes the resume button.
  await page.getByRole('button', { name: 'Stop' }).press('Enter');
  await page.getByText('Stopped: interim results are shown.').waitFor();
  await page.getByText('Simulating').waitFor({ state: 'detached' });
  const goOn = page.getByRole('button', { name: 'Go on' });
  await expect.poll(() => goOn.evaluate((button) => button === document.activeElement)).toBe(true);
  const kept = await computed(visit);
  expect(kept).toBeGreaterThanOrEqual(shown);
  await visit.shot('simulation-stopped');
  // An unrelated edit does not restart it.
  await page.getByRole('tab', { name: 'Controls' }).click();
  await page.getByRole('textbox', { name: 'Exposure' }).fill('1');
  await page.getByRole('textbox', { name: 'Exposure' }).press('Enter');
  await page.getByRole('tab', { name: 'Energy' }).click();
  expect(await computed(visit)).toBe(kept);
  expect(await page.getByText('Simulating').count()).toBe(0);

  await goOn.click();
  await page.getByText('Simulating').waitFor();
  const first = await computed(visit);
  expect(first).toBeGreaterThanOrEqual(kept);
  await expect.poll(() => computed(visit)).toBeGreaterThan(kept + 0.1);
  await visit.close();
});

it('the GPU computes the steps in a worker of the page, if so set', async () => {
  const visit = await (await program.open('?scene=examples/sphere.usdc')).ready();
  const { page } = visit;
  const content = Buffer.from(hanging({ onGpu: true, duration: 0.5 }));
  await drop(visit, [{ name: 'cloth.slowlight.json', content }]);
  await page.getByRole('tab', { name: 'Energy' }).click();
  await page.locator('.sl-energy tbody', { hasText: 'Leapfrog GPU' }).waitFor();
  await page.getByText('Simulating').waitFor({ state: 'detached' });
  const plot = page.getByRole('slider', { name: 'Change of energy over time' });
  await plot.press('End');
  await expect.poll(() => plot.getAttribute('aria-valuetext')).toMatch(/^0\.50 s: Leapfrog GPU −0\.\d+ J$/);
  await visit.close();
});
