import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { AxeBuilder } from '@axe-core/playwright';
import { EXTTextureWebP, KHRTextureBasisu } from '@gltf-transform/extensions';
import { zipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { withSphericalPng } from '../../src/formats/spherical/sphericalPictures.ts';
import { PINK_WEBP } from '../formats/pictures.ts';
import { GltfBuilder } from '../support/gltfBuilder.ts';
import { solidKtx2 } from '../support/ktx2Kit.ts';
import { makeTestFilm } from '../support/testFilm.ts';
import { difference, type MonitoredPage, Program, sharedPage, WINDOW } from './program.ts';
import { drop, pinkShare, sceneBytes } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

const opened = sharedPage(async () => (await program.open('?backend=webgl&scene=examples/sphere.usdc')).ready());
const text = (words: string) => new TextEncoder().encode(words);
const TEXTURED = { name: 'textured.usda', content: sceneBytes('textured.usda') };
const CHECKER = { name: 'checker.png', content: sceneBytes('textures/checker.png') };

async function visitScenePanel(visit: MonitoredPage): Promise<void> {
  await visit.page.getByRole('tab', { name: 'Scene' }).click();
}

/** Chooses an option of a select by its label. */
async function choose(page: Page, label: string | RegExp, option: string | RegExp): Promise<void> {
  await page.getByRole('combobox', { name: label }).click();
  await page.getByRole('option', { name: option }).click();
}

const violations = async (page: Page) => {
  const found = await new AxeBuilder({ page }).analyze();
  return found.violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
};

/** Which of red, green and blue is clearly the brightest in the middle: exposure may make it pale. */
async function brightest(visit: MonitoredPage): Promise<number> {
  const rgb = (await visit.middle()).slice(0, 3);
  const most = rgb.indexOf(Math.max(...rgb));
  return rgb.every((value, k) => k === most || value < rgb[most]! - 40) ? most : -1;
}

/** A square that fills the view in one of two colours, and beside it an object of a group. */
const VARIANTS = `#usda 1.0
( customLayerData = { dictionary slowlight = { double speedOfLight = 30 } }
  metersPerUnit = 1
  upAxis = "Y" )
def Xform "World"
{
    def Xform "Car" (
        variants = { string paint = "grey" }
        prepend variantSets = "paint"
    )
    {
        def Mesh "Body" {
            uniform token subdivisionScheme = "none"
            int[] faceVertexCounts = [4]
            int[] faceVertexIndices = [0, 1, 2, 3]
            point3f[] points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
            uniform bool doubleSided = 1
        }
        variantSet "paint" = {
            "grey" { over "Body" { color3f[] primvars:displayColor = [(0.3, 0.3, 0.3)]; } }
            "pink" { over "Body" { color3f[] primvars:displayColor = [(1, 0, 1)]; } }
        }
    }
    def Mesh "Wall" {
        uniform token subdivisionScheme = "none"
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(-9, -1, -2), (-2, -1, -2), (-2, 1, -2), (-9, 1, -2)]
        uniform bool doubleSided = 1
        double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 48: (4, 0, 0) }
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
}
`;

/** Drops a scene, and waits until the panel shows it instead of the previous one. */
async function openCar(visit: MonitoredPage): Promise<void> {
  await visit.opens(() => drop(visit, [{ name: 'car.usda', content: Buffer.from(VARIANTS) }]));
  await visitScenePanel(visit);
  await visit.page.getByRole('combobox', { name: 'paint' }).waitFor();
}

describe('opening files', () => {
  it('a zip opens with its texture; other scenes in it can be chosen', async () => {
    const visit = await opened();
    const packed = zipSync({
      'set/textured.usda': new Uint8Array(TEXTURED.content),
      'set/textures/checker.png': new Uint8Array(CHECKER.content),
      'set/parts/car.usda': text(VARIANTS),
      '__MACOSX/set/._textured.usda': text('fork'),
    });
    await drop(visit, [{ name: 'set.zip', content: Buffer.from(packed) }]);
    await visit.page.getByText('The square wears the picture').waitFor();
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await visitScenePanel(visit);
    await choose(visit.page, 'Scene in these files', 'set.zip/set/parts/car.usda');
    await visit.page.getByText('car.usda', { exact: true }).waitFor();
    await visit.page.getByRole('combobox', { name: 'paint' }).waitFor();
    await visit.shot('openFiles-zip');
    expect(await violations(visit.page)).toEqual([]);

    // A texture that the browser decodes.
    const kit = new GltfBuilder();
    const pink = kit.doc.createTexture().setImage(PINK_WEBP).setMimeType('image/webp');
    const square = kit
      .triangle([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0])
      .setIndices(kit.ints('SCALAR', [0, 1, 2, 0, 2, 3]))
      .setAttribute('TEXCOORD_0', kit.values('VEC2', [0, 1, 1, 1, 1, 0, 0, 0]))
      .setMaterial(kit.doc.createMaterial('Pink').setBaseColorTexture(pink));
    kit.doc.createExtension(EXTTextureWebP).setRequired(true);
    kit.scene.addChild(kit.meshNode('Square', square));
    expect(pinkShare(await visit.pixels())).toBeLessThan(0.01);
    await drop(visit, [{ name: 'pink.glb', content: Buffer.from(await kit.glb()) }]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await visit.shot('openFiles-webp');

    // And one that our own code decodes, loaded under the page's policy.
    await drop(visit, [{ name: 'sphere.usdc', content: sceneBytes('../../../examples/sphere.usdc') }]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeLessThan(0.01);
    pink.setImage(solidKtx2(200, 60, 120, 255)).setMimeType('image/ktx2');
    kit.doc.createExtension(EXTTextureWebP).dispose();
    kit.doc.createExtension(KHRTextureBasisu).setRequired(true);
    await drop(visit, [{ name: 'pink-ktx2.glb', content: Buffer.from(await kit.glb()) }]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.03);
    await visit.shot('openFiles-ktx2');
  });

  it('a zip with references outside of itself is rejected, and the scene stays', async () => {
    const visit = await opened();
    await drop(visit, [{ name: 'bad.zip', content: Buffer.from(zipSync({ '../x.usda': text('#usda 1.0') })) }]);
    await visit.refusals.waitFor();
    expect(await visit.refusals.textContent()).toMatch(/bad\.zip.*leads out of it/);
    expect(await visit.triangles()).toBeGreaterThan(0);
    await visit.refusals.getByRole('button', { name: 'Close' }).click();
  });

  it('missing files are listed with their referrers, and can be supplied; the observer stays', async () => {
    const visit = await opened();
    await visit.opens(() => drop(visit, [TEXTURED]));
    const warning = visit.page.getByText(/^Missing files: 1 \(\.\/textures\/checker\.png\)/);
    await warning.waitFor();
    await visitScenePanel(visit);
    const item = visit.page.locator('[data-missing="./textures/checker.png"]');
    await item.waitFor();
    expect(await item.textContent()).toMatch(/for .*textured\.usda<\/.*searched textures\/checker\.png/);
    await visit.shot('openFiles-missing');
    expect(await violations(visit.page)).toEqual([]);
    await visit.viewport.click();
    for (const key of ['ArrowLeft', 'ArrowUp']) await visit.page.keyboard.press(key, { delay: 120 });
    await visit.page.keyboard.press('Escape');
    await expect.poll(async () => pinkShare(await visit.pixels())).toBe(0); // The previous scene's picture stays until this one is drawn.
    const own = await visit.page.evaluate(() => document.querySelector('[data-opened]')?.getAttribute('data-opened'));
    await drop(visit, [CHECKER]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.01);
    await expect.poll(() => item.count()).toBe(0);
    await expect.poll(() => warning.count()).toBe(0);
    expect(own).toMatch(/^local:\d+\/textured\.usda$/);
    await visit.page.getByRole('button', { name: /^Undo: add missing files/ }).click();
    await item.waitFor();
  });

  it('a file without objects is reported, until another is opened', async () => {
    const visit = await opened();
    await drop(visit, [{ name: 'empty.usda', content: Buffer.from('#usda 1.0\n') }]);
    const warning = visit.page.getByText(/^There are no objects in empty\.usda/);
    await warning.waitFor();
    await openCar(visit);
    await expect.poll(() => warning.count()).toBe(0);
  });

  it('a panorama is seen all around, and a photograph is refused', async () => {
    // Red ahead, grey elsewhere.
    const pixels = Uint8Array.from({ length: 4 * 256 * 128 }, (_, i) => {
      if (i % 4 === 3) return 255;
      const isAhead = Math.abs(((i >> 2) % 256) - 128) < 32;
      return isAhead ? 255 * Number(i % 4 === 0) : 90;
    });
    const visit = await opened();
    await visit.opens(() => drop(visit, [{ name: 'sky.png', content: Buffer.from(encodePng(256, 128, pixels)) }]));
    await expect.poll(async () => (await visit.middle()).slice(0, 2)).toSatisfy(([r, g]) => r > 200 && g < 100);
    expect(await visit.page.getByText(/^There are no objects/).count()).toBe(0);
    await drop(visit, [{ name: 'photo.png', content: CHECKER.content }]);
    await visit.refusals.waitFor();
    expect(await visit.refusals.textContent()).toMatch(/photo\.png.*no panorama; one is twice as wide as high/);
    await visit.refusals.getByRole('button', { name: 'Close' }).click();
  });

  it('six faces are one panorama, as files or in a zip; of two eyes’ pictures the left one is seen', async () => {
    const face = (r: number, g: number, b: number, width = 16, height = 16): Uint8Array =>
      encodePng(
        width,
        height,
        Uint8Array.from({ length: 4 * width * height }, (_, i) => [r, g, b, 255][i % 4]!),
      );
    const facesWith = (front: Uint8Array) =>
      ['right', 'left', 'top', 'bottom', 'front', 'back'].map((name) => ({
        name: `room_${name}.png`,
        content: Buffer.from(name === 'front' ? front : face(90, 90, 90)),
      }));
    const visit = await opened();
    await visit.opens(() => drop(visit, facesWith(face(255, 0, 0))));
    await expect.poll(() => brightest(visit)).toBe(0);
    const packed = zipSync(
      Object.fromEntries(facesWith(face(0, 0, 255)).map(({ name, content }) => [`a/${name}`, new Uint8Array(content)])),
    );
    await visit.opens(() => drop(visit, [{ name: 'room.zip', content: Buffer.from(packed) }]));
    await expect.poll(() => brightest(visit)).toBe(2);
    // The upper half is the left eye's.
    const eyes = Uint8Array.from({ length: 4 * 32 * 32 }, (_, i) =>
      i % 4 === 3 || (i < 2048 ? i % 4 === 1 : i % 4 === 0) ? 255 : 0,
    );
    const both = withSphericalPng(encodePng(32, 32, eyes), { projection: 'equirectangular', stereo: 'top-bottom' });
    await visit.opens(() => drop(visit, [{ name: 'eyes.png', content: Buffer.from(both) }]));
    await expect.poll(() => brightest(visit)).toBe(1);
  });

  it('a film is seen all around, with the picture of the time; what is no panorama is refused', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-film-'));
    const film = { colors: ['red', 'lime', 'blue'], seconds: 1, rate: 10, width: 256, height: 128 };
    const content = makeTestFilm(folder, 'film.mp4', film);
    const visit = await opened();
    await visit.opens(() => drop(visit, [{ name: 'film.mp4', content }]));
    await expect.poll(() => brightest(visit)).toBe(0);
    const time = visit.page.getByRole('slider', { name: 'World time' });
    expect(await time.getAttribute('aria-valuemax')).toBe('3');
    await time.focus();
    for (const [key, color] of [
      ['End', 2],
      ['Home', 0],
    ] as const) {
      await time.press(key);
      await expect.poll(() => brightest(visit)).toBe(color);
    }
    await visit.page.getByRole('button', { name: 'Play', exact: true }).click();
    // It does not stop, and goes through all colours.
    for (const color of [1, 2, 0]) await expect.poll(() => brightest(visit), { interval: 20 }).toBe(color);
    await visit.page.getByRole('button', { name: 'Pause', exact: true }).click();
    await (await visit.finest()).shot('openFiles-film');
    const wide = makeTestFilm(folder, 'wide.mp4', { ...film, colors: ['red'], height: 144 });
    await drop(visit, [{ name: 'wide.mp4', content: wide }]);
    await visit.refusals.waitFor();
    expect(await visit.refusals.textContent()).toMatch(/wide\.mp4.*256 × 144 pixels, and is no panorama/);
    await visit.refusals.getByRole('button', { name: 'Close' }).click();
    rmSync(folder, { recursive: true });
  });

  it('missing files of a scene on the server can be supplied too', async () => {
    const visit = await program.open('?backend=webgl&scene=examples/asked.usda', {}, async (page) => {
      await page.route('**/examples/asked.usda', (route) => route.fulfill({ body: TEXTURED.content }));
      await page.route('**/examples/textures/checker.png', (route) => route.fulfill({ status: 404 }));
    });
    await visit.page.getByText('The square wears the picture').waitFor();
    await visit.ready();
    await drop(visit, [CHECKER]);
    await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.01);
    await visit.close();
  });

  it('a variant can be chosen, is stored in the document and undone; the view stays', async () => {
    const visit = await opened();
    await openCar(visit);
    const paintPink = async (): Promise<void> => {
      await choose(visit.page, 'paint', 'pink');
      await expect.poll(async () => pinkShare(await visit.pixels())).toBeGreaterThan(0.02);
    };
    // Once it has been pink, it is not the picture of the scene before.
    await paintPink();
    await choose(visit.page, 'paint', 'grey');
    await expect.poll(async () => pinkShare(await visit.pixels())).toBe(0);
    const gray = await (await visit.finest()).pixels();
    await paintPink();
    await visit.shot('openFiles-variants');
    await visit.page.getByRole('button', { name: /^Undo: choose a variant/ }).click();
    await visit.page.mouse.move(0, 0); // The button's tooltip covers the picture.
    await expect.poll(async () => difference(await visit.pixels(), gray)).toBeLessThan(0.5);
  });

  it('reading reports its stage and progress, and can be stopped at once', async () => {
    let release = () => {};
    const released = new Promise<void>((done) => {
      release = done;
    });
    const visit = await opened();
    await visit.page.route('**/examples/street.usdc', async (route) => {
      await released;
      await route.continue().catch(() => {});
    });
    const before = await (await visit.finest()).pixels();
    await visit.page.getByRole('button', { name: 'Scenes' }).click();
    await visit.page.locator('[data-example="street"]').click();
    const bar = visit.page.getByRole('progressbar', { name: 'Reading the file' });
    await bar.waitFor();
    expect(await bar.getAttribute('aria-valuenow')).toBeNull();
    await visit.shot('openFiles-reading');
    await visit.page.getByRole('button', { name: 'Cancel' }).click();
    await bar.waitFor({ state: 'detached' });
    expect(difference(await visit.pixels(), before)).toBeLessThan(1);
    expect(visit.page.workers().filter((worker) => worker.url().includes('loader.worker'))).toEqual([]);
    release();
  });
});

describe('motion', () => {
  const motion = (visit: MonitoredPage) => visit.page.getByRole('region', { name: 'Motion' });

  /** By keyboard only. */
  async function findThing(visit: MonitoredPage, words: string): Promise<void> {
    const search = motion(visit).getByRole('combobox', { name: 'Make something fly' });
    await search.fill(words);
    await visit.page.getByRole('option').first().waitFor();
    // The list appears without a selection a moment after the input.
    await expect
      .poll(async () => {
        await search.press('ArrowDown');
        return visit.page.locator('[role=option][data-combobox-selected]').count();
      })
      .toBe(1);
    await search.press('Enter');
  }

  it('an animation can run faster, and is rejected where it would exceed c', async () => {
    const visit = await opened();
    await openCar(visit);
    const speed = motion(visit).getByRole('textbox', { name: 'Animation speed' });
    await speed.fill('2');
    await speed.press('Enter');
    await visit.page.getByText('0.00 s … 1.00 s').waitFor();
    await visit.page.getByText('4.00 m/s at t =').waitFor();
    await visit.page.getByText('Paths between samples').waitFor();
    await visit.shot('openFiles-motion');
    await speed.fill('40');
    await speed.press('Enter');
    await visit.refusals.getByRole('button', { name: /Set Speed of light to/ }).waitFor();
    await visit.page.getByRole('button', { name: /^Undo/ }).click();
    await expect.poll(() => visit.refusals.count()).toBe(0);
  });

  it('an object is found by keyboard and given a flight at 0.8 c; direction and end can be chosen', async () => {
    const visit = await opened();
    await openCar(visit);
    await findThing(visit, 'Body');
    const flight = visit.page.getByRole('group', { name: 'Flight: /World/Car/Body' });
    await flight.waitFor();
    await visit.page.getByText('24.0 m/s at t =').waitFor();
    await flight.getByRole('textbox', { name: 'Speed', exact: true }).fill('0.5');
    await flight.getByRole('textbox', { name: 'Speed', exact: true }).press('Enter');
    await visit.page.getByText('15.0 m/s at t =').waitFor();
    await choose(visit.page, 'Direction', '−X');
    await expect.poll(() => flight.getByRole('textbox', { name: 'Direction x' }).inputValue()).toBe('-1');
    await visit.page.mouse.move(0, 0);
    await visit.shot('openFiles-flight');
    expect(await violations(visit.page)).toEqual([]);
    await flight.getByRole('button', { name: 'Move as in the file again' }).click();
    await expect.poll(() => flight.count()).toBe(0);
    await visit.page.getByText('2.00 m/s at t =').waitFor();
  });

  it('the panel fits its width, in light and dark colours', async () => {
    const visit = await opened();
    await openCar(visit);
    await findThing(visit, 'Wall');
    for (const [colorScheme, viewport] of [
      ['light', { width: 1280, height: 900 }],
      ['dark', { width: 390, height: 844 }],
    ] as const) {
      await visit.page.emulateMedia({ colorScheme });
      await visit.page.setViewportSize(viewport);
      await visit.page.locator(`html[data-mantine-color-scheme=${colorScheme}]`).waitFor();
      await visit.page.getByRole('group', { name: 'Flight: /World/Wall' }).scrollIntoViewIfNeeded();
      await visit.shot(`openFiles-${colorScheme}-${viewport.width}`);
      const overflow = () => visit.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      await expect.poll(overflow).toBeLessThanOrEqual(0);
      expect(await violations(visit.page)).toEqual([]);
    }
    await visit.page.setViewportSize(WINDOW);
  });
});
