import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { KHRMaterialsUnlit } from '@gltf-transform/extensions';
import { decode } from 'fast-png';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Example } from '../../src/editor/loading/examples.ts';
import { GltfBuilder } from '../support/gltfBuilder.ts';
import { dracoGlb, meshoptGlb } from '../support/gltfCompress.ts';
import { colorCount, difference, type MonitoredPage, Program, sharedPage } from './program.ts';
import { drop, pinkShare } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const path = (name: string) => fileURLToPath(new URL(`scenes/${name}`, import.meta.url));
/** Each test leaves it with the scene of its address: a ball that passes at half the speed of light. */
const opened = sharedPage(async () => (await program.open('?backend=webgl&scene=examples/sphere.usdc')).ready());

/** Undoes what was opened; the pointer leaves the button, whose tooltip would cover the picture. */
async function undo({ page }: MonitoredPage): Promise<void> {
  await page.getByRole('button', { name: /^Undo/ }).click();
  await page.mouse.move(0, 0);
}

describe('scenes', () => {
  it('every scene of the gallery opens, draws something, and shows what to look for', async () => {
    const visit = await (await program.open('?backend=webgl')).ready();
    await visit.page.addStyleTag({ content: '.sl-picture { inline-size: 240px; block-size: 160px; }' });
    const examples = (await (await fetch(`${program.url}/examples/index.json`)).json()) as Example[];
    expect(examples.map(({ name }) => name)).toContain('street');
    for (const { name, source, lookFor } of examples) {
      expect(lookFor.length, `${name} says what to look for`).toBeGreaterThan(20);
      // One project is enough, because the command line's tests render them all.
      if (source.endsWith('.slowlight.json') && name !== 'workshop') continue;
      await visit.page.getByRole('button', { name: 'Scenes' }).click();
      await visit.page.locator(`[data-example="${name}"]`).click();
      await expect.poll(() => visit.page.locator('[data-opened]').getAttribute('data-opened')).toContain(`/${name}.`);
      // Until then the picture is that of the previous scene.
      await visit.page.getByText('Preparing the picture').waitFor({ state: 'hidden' });
      await expect.poll(() => visit.triangles()).toBeGreaterThan(0);
      await expect.poll(async () => colorCount(await visit.pixels())).toBeGreaterThan(50);
      await visit.shot(`scene-${name}`);
    }
    await visit.close();
  });

  it('a dropped scene opens with its texture, and undo returns to the previous one', async () => {
    const visit = await (await opened()).finest();
    const before = await visit.pixels();
    await drop(visit, [
      { name: 'textured.usda', content: readFileSync(path('textured.usda')) },
      { name: 'checker.png', content: readFileSync(path('textures/checker.png')) },
    ]);
    await visit.page.getByText('The square wears the picture').waitFor();
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await visit.shot('dropped');
    await undo(visit);
    await expect.poll(async () => difference(await visit.pixels(), before)).toBeLessThan(1);
  });

  it('a chosen file opens; missing files are reported', async () => {
    const visit = await opened();
    await visit.page.locator('input[type=file]').first().setInputFiles(path('textured.usda'));
    await visit.page.getByText('The square wears the picture').waitFor();
    await visit.page.getByRole('tab', { name: 'Scene' }).click();
    await visit.page.getByText('checker.png').first().waitFor();
    await visit.page.getByRole('tab', { name: 'Controls' }).click();
    await undo(visit);
    await visit.page.getByText('The square wears the picture').waitFor({ state: 'detached' });
  });

  it.each([
    ['Draco', (kit: GltfBuilder) => dracoGlb(kit.doc, 'edgebreaker')],
    ['meshopt', (kit: GltfBuilder) => meshoptGlb(kit.doc, 'quantize')],
  ])('glTF compressed with %s opens under the page’s content security policy', async (_, write) => {
    const kit = new GltfBuilder();
    const pink = kit.doc.createMaterial().setBaseColorFactor([1, 0, 1, 1]).setDoubleSided(true);
    pink.setExtension('KHR_materials_unlit', kit.doc.createExtension(KHRMaterialsUnlit).createUnlit());
    const square = kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]).setMaterial(pink);
    kit.scene.addChild(kit.meshNode('Square', square.setIndices(kit.ints('SCALAR', [0, 1, 2, 2, 1, 3]))));
    const buffer = Buffer.from(await write(kit));
    const visit = await opened();
    // Moving globes are a little pink themselves.
    expect(pinkShare(await visit.pixels())).toBeLessThan(0.01);
    const file = { name: 'square.glb', mimeType: 'model/gltf-binary', buffer };
    await visit.page.locator('input[type=file]').first().setInputFiles(file);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await undo(visit);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeLessThan(0.01);
  });

  it('a dropped OBJ opens with its materials', async () => {
    const visit = await opened();
    const obj = 'mtllib square.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl pink\nf 1 2 3 4\n';
    await drop(visit, [
      { name: 'square.mtl', content: Buffer.from('newmtl pink\nKd 0 0 0\nKs 0 0 0\nKe 1 0 1\n') },
      { name: 'square.obj', content: Buffer.from(obj) },
    ]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await undo(visit);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeLessThan(0.01);
  });

  it('an unreadable file is rejected with file and place, and the scene stays', async () => {
    const visit = await (await opened()).finest();
    const before = await visit.pixels();
    await visit.page
      .locator('input[type=file]')
      .first()
      .setInputFiles({
        name: 'broken.usda',
        mimeType: 'text/plain',
        buffer: Buffer.from('#usda 1.0\ndef Mesh "a" {\n  int[] x = [1, 2\n'),
      });
    const notice = visit.refusals;
    await notice.waitFor();
    const said = await notice.textContent();
    expect(said).toMatch(/broken\.usda/);
    expect(said).toMatch(/last valid scene/);
    await visit.shot('refused');
    expect(difference(await visit.pixels(), before)).toBeLessThan(1);
    await undo(visit);
    await expect.poll(() => notice.count()).toBe(0);
  });

  it('a speed of light below the scene’s speeds is rejected with a remedy that works', async () => {
    const visit = await opened();
    const field = visit.page.getByRole('textbox', { name: 'Speed of light' });
    await field.fill('0.2');
    await field.press('Enter');
    const remedy = visit.refusals.getByRole('button', { name: /Set Speed of light to/ });
    await remedy.click();
    await expect.poll(() => visit.refusals.count()).toBe(0);
    expect(await visit.status('c')).not.toContain('0.2');
  });

  it('the picture is saved as a PNG of the displayed size', async () => {
    const visit = await opened();
    const size = await visit.page.locator('canvas').evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight]);
    const download = visit.page.waitForEvent('download');
    await visit.page.keyboard.press('Control+Shift+s');
    const file = await download;
    expect(file.suggestedFilename()).toMatch(/^sphere t=.*c\.png$/);
    const picture = decode(readFileSync(await file.path()));
    expect([picture.width, picture.height]).toEqual(size);
    expect(colorCount(Uint8Array.from(picture.data))).toBeGreaterThan(50);
  });
});
