import { afterAll, beforeAll, expect, it } from 'vitest';
import { encodeShareLink } from '../../src/graph/document/shareLink.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';
import { connect } from '../support/graphKit.ts';
import { difference, type MonitoredPage, Program } from './program.ts';
import { ASKED, pinkShare, serveAsked } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const effect = (color: string) => `fn effect(p: Pixel) -> vec4f {\n  return vec4f(${color}, 1);\n}`;
/** Nearly the maximum number of steps per pixel of an effect text. */
const SLOW = `fn effect(p: Pixel) -> vec4f {
  var x = p.color.rgb;
  for (var i = 0; i < 64; i++) {
    for (var k = 0; k < 64; k++) { x = sin(x * 1.3 + vec3f(0.1)); }
  }
  return vec4f(x.ggg, 1);
}`;

const messageOf = ({ page }: MonitoredPage) => page.getByRole('textbox', { name: 'Shader text' });
async function write(visit: MonitoredPage, text: string): Promise<void> {
  await messageOf(visit).fill(text);
  await messageOf(visit).press('Control+Enter');
}

async function undo({ page }: MonitoredPage): Promise<void> {
  await page.getByRole('button', { name: /^Undo: Shader text/ }).click();
  // The button's tooltip would cover the picture.
  await page.mouse.move(0, 0);
}

/** The final picture, once it has no magenta of the checkerboard. */
async function gray(visit: MonitoredPage): Promise<Uint8Array> {
  await visit.ready();
  await expect.poll(async () => pinkShare(await visit.pixels())).toBeLessThan(0.005);
  return (await visit.finest()).pixels();
}

/** The lit scene through a user-written effect, beside an ordinary picture of it. */
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
  return applyCommand(newProject(ASKED), { kind: 'batch', commands }).document;
}

it('a picture composed of nodes is drawn; an invalid effect text is rejected with its line, and the last valid picture stays', async () => {
  const page = await program.open(`?backend=webgl#${encodeShareLink(project())}`, {}, serveAsked);
  const before = await gray(page);
  await write(page, effect('p.color.ggg * nothing'));
  await page.refusals.waitFor();
  expect(await page.refusals.textContent()).toMatch(/line 2, column \d+: .*nothing/);
  expect(difference(await page.pixels(), before)).toBeLessThan(0.5);
  await page.shot('shader-text-refused');
  await write(page, effect('p.color.rgb'));
  await expect.poll(async () => pinkShare(await page.pixels())).toBeGreaterThan(0.03);
  const alpha = page.page.getByRole('textbox', { name: 'Alpha' });
  await write(page, effect('p.color.ggg'));
  await alpha.fill('1');
  await alpha.press('Enter');
  // The ordinary picture only.
  await expect.poll(async () => pinkShare(await page.pixels())).toBeGreaterThan(0.03);
  await page.close();
});

it('an effect text of maximum cost slows the picture, not the page', async () => {
  const page = await program.open(`?backend=webgl#${encodeShareLink(project())}`, {}, serveAsked);
  const before = await gray(page);
  await write(page, SLOW);
  await expect.poll(async () => difference(await page.pixels(), before)).toBeGreaterThan(5);
  await undo(page);
  await expect.poll(async () => difference(await page.pixels(), before)).toBeLessThan(0.5);
  await page.close();
});

it.each([
  ['webgl', 'loses its context'],
  ['webgpu', 'loses its device'],
])('on %s a picture with a user-written effect is restored, with all edits, when it %s', async (backend) => {
  const options = { viewport: { width: 640, height: 480 } };
  const page = await program.open(`?backend=${backend}#${encodeShareLink(project())}`, options, serveAsked);
  const first = await gray(page);
  await write(page, effect('1 - p.color.ggg'));
  await expect.poll(async () => difference(await page.pixels(), first)).toBeGreaterThan(5);
  const before = await (await page.finest()).pixels();
  if (backend === 'webgpu') await program.crashGraphics();
  else
    await page.page.locator('canvas').evaluate((canvas: HTMLCanvasElement) => {
      canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    });
  await page.page.getByText('was lost and has been restarted').waitFor();
  await expect.poll(async () => difference(await page.pixels(), before)).toBeLessThan(0.5);
  expect(await messageOf(page).inputValue()).toContain('1 - p.color');
  await undo(page);
  await expect.poll(async () => difference(await page.pixels(), first)).toBeLessThan(0.5);
  page.expectComplaint(/Device Lost/);
  await page.close();
});
