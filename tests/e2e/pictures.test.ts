import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { applyCommand, type Command } from '../../src/graph/commands.ts';
import { sharedFragment } from '../../src/graph/share.ts';
import { newProject } from '../../src/nodes/project.ts';
import { connect } from '../support/graphKit.ts';
import { difference, Program } from './program.ts';
import { pinkShare } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const bytes = (name: string) => readFileSync(fileURLToPath(new URL(`scenes/${name}`, import.meta.url)));
const SQUARE = bytes('textured.usda');
const CHECKER = bytes('textures/checker.png');

const effect = (color: string) => `fn effect(p: Pixel) -> vec4f {\n  return vec4f(${color}, 1);\n}`;

/** What is lit, through an effect that somebody wrote, beside an ordinary picture of the same. */
function project() {
  const commands: Command[] = [
    { kind: 'set-param', node: 'toneMap', param: 'metering', value: 'manual' },
    {
      kind: 'add-node',
      node: 'own',
      type: 'post-process',
      at: [0, 300],
      params: { effect: 'written', text: effect('p.color.ggg') },
    },
    { kind: 'add-node', node: 'plain', type: 'rasterize', at: [0, 500] },
    { kind: 'add-node', node: 'plainLight', type: 'deferred-lighting', at: [240, 500] },
    { kind: 'add-node', node: 'mix', type: 'mix-color', at: [240, 300], params: { mode: 'split', alpha: 0 } },
    connect('camera.view', 'plain.view'),
    connect('plain.gbuffer', 'plainLight.gbuffer'),
    connect('lighting.image', 'own.image'),
    connect('plainLight.image', 'mix.below'),
    connect('own.image', 'mix.above'),
    connect('mix.image', 'toneMap.image'),
  ];
  return applyCommand(newProject('examples/asked.usda'), { kind: 'batch', commands }).document;
}

it('a picture that is put together of nodes is drawn, a text that cannot be is refused with its line, and the last good picture stays', async () => {
  const page = await program.open(`?backend=webgl#${sharedFragment(project())}`, {}, async (tab) => {
    await tab.route('**/examples/asked.usda', (route) => route.fulfill({ body: SQUARE }));
    await tab.route('**/examples/textures/checker.png', (route) => route.fulfill({ body: CHECKER }));
  });
  await page.ready();
  const text = page.page.getByRole('textbox', { name: 'Shader text' });
  const write = async (color: string): Promise<void> => {
    await text.fill(effect(color));
    await text.press('Control+Enter');
  };
  await expect.poll(async () => pinkShare(await page.pixels())).toBeLessThan(0.005);
  const before = await page.pixels();
  await write('p.color.ggg * nothing');
  await page.refusals.waitFor();
  expect(await page.refusals.textContent()).toMatch(/line 2, column \d+: .*nothing/);
  expect(difference(await page.pixels(), before)).toBeLessThan(0.5);
  await page.shot('shader-text-refused');
  await write('p.color.rgb');
  await expect.poll(async () => pinkShare(await page.pixels())).toBeGreaterThan(0.03);
  const alpha = page.page.getByRole('textbox', { name: 'Alpha' });
  await write('p.color.ggg');
  await alpha.fill('1');
  await alpha.press('Enter');
  // The ordinary picture alone.
  await expect.poll(async () => pinkShare(await page.pixels())).toBeGreaterThan(0.03);
  await page.close();
});
