import { afterAll, beforeAll, expect, it } from 'vitest';
import { truth } from '../../examples/projects/truth.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { colorCount, difference, Program } from './program.ts';
import { drop } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const set = (node: string, param: string, value: number | string): Command => ({
  kind: 'set-param',
  node,
  param,
  value,
});
/** The still only, at a size that takes a second. */
const commands = [
  set('truth', 'width', 96),
  set('truth', 'height', 54),
  set('truth', 'samples', 1),
  set('both', 'alpha', 1),
  set('toneMap', 'metering', 'manual'),
];
const project = serializeDocument(applyCommand(truth(), { kind: 'batch', commands }).document);

/** Whether the picture is wider than the still, and black beside it. */
function blackShare(pixels: Uint8Array): number {
  let black = 0;
  for (let i = 0; i + 2 < pixels.length; i += 3) if (pixels[i]! + pixels[i + 1]! + pixels[i + 2]! === 0) black++;
  return (3 * black) / pixels.length;
}

it('a reference render reports progress on its node, is displayed, stays while the next one is rendered, and can be cancelled', async () => {
  const options = { viewport: { width: 1100, height: 760 } };
  const visit = await (await program.open('?backend=webgl&scene=examples/sphere.usdc', options)).ready();
  const { page } = visit;
  const work = page.locator('.react-flow__node[data-id="truth"]').getByRole('progressbar');
  const samples = page.getByRole('textbox', { name: 'Samples', exact: true });
  const tracers = () => page.workers().filter((worker) => worker.url().includes('/renderStill.worker'));
  const sample = async (n: string): Promise<void> => {
    await samples.fill(n);
    await samples.press('Enter');
  };
  await page.keyboard.press('Control+Shift+G');
  // The graph that is shown already makes room for that of another project.
  await page.locator('.react-flow__node').first().waitFor();
  await drop(visit, [{ name: 'truth.slowlight.json', content: Buffer.from(project) }]);
  await page.getByText('A room at 0.1 c').waitFor();
  await expect.poll(async () => blackShare(await visit.pixels())).toBeGreaterThan(0.15);
  const before = await visit.pixels();
  expect(colorCount(before)).toBeGreaterThan(200);
  await visit.shot('reference-node');

  await page.locator('.react-flow__node[data-id="truth"] .sl-node-head').click();
  await sample('16');
  // Zoomed out, progress is only a bar.
  await work.waitFor({ state: 'attached' });
  await expect.poll(() => work.textContent()).toMatch(/^[1-9]\d?\u202f%$/);
  expect(tracers()).toHaveLength(1);
  await visit.shot('reference-node-works');
  expect(difference(await visit.pixels(), before)).toBeLessThan(0.5);
  await page.getByRole('button', { name: 'Cancel' }).click();
  await work.waitFor({ state: 'detached' });
  await expect.poll(tracers).toEqual([]);
  expect(difference(await visit.pixels(), before)).toBeLessThan(0.5);

  // Another picture: its noise differs.
  await sample('2');
  await expect.poll(async () => difference(await visit.pixels(), before)).toBeGreaterThan(0.5);
  await work.waitFor({ state: 'detached' });

  // And without noise, by a network that is loaded now.
  const noisy = await visit.pixels();
  await page.getByRole('switch', { name: 'Denoise' }).press('Space');
  await expect.poll(async () => difference(await visit.pixels(), noisy)).toBeGreaterThan(0.5);
  await visit.shot('reference-node-denoised');
  await visit.close();
});
