import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { decode } from 'fast-png';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import { withSphericalPng } from '../../src/formats/spherical/sphericalPictures.ts';
import type { SphericalPicture } from '../../src/scene/view/sphericalPicture.ts';
import { Program } from './program.ts';

/** Pictures as a player of 360° pictures of others reads and shows them: Pannellum, in the browser. */

const require = createRequire(import.meta.url);
const STYLE = readFileSync(require.resolve('pannellum/build/pannellum.css'), 'utf8');
const SCRIPT = readFileSync(require.resolve('pannellum/build/pannellum.js'), 'utf8');

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

/** Colours of what is ahead, right, behind and left, 90° each, and of the upper and lower quarter of the picture. */
const [AHEAD, RIGHT, BEHIND, LEFT, ABOVE, BELOW] = [
  [255, 0, 0],
  [0, 255, 0],
  [0, 0, 255],
  [255, 255, 0],
  [255, 0, 255],
  [0, 255, 255],
] as const;

/** Of the whole sphere of so many pixels, the rectangle from (left, top). */
function picture(full: readonly [number, number], left: number, top: number, width: number, height: number) {
  const pixels = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [(left + (i % width) + 0.5) / full[0], (top + Math.floor(i / width) + 0.5) / full[1]];
    const side = [BEHIND, LEFT, AHEAD, RIGHT, BEHIND][Math.floor(4 * x + 0.5)]!;
    pixels.set([...(y < 0.25 ? ABOVE : y > 0.75 ? BELOW : side), 255], 4 * i);
  }
  return encodePng(width, height, pixels);
}

interface PlayerWindow {
  readonly pannellum: { viewer(id: string, config: object): Player };
  player: Player;
}
interface Player {
  on(event: 'load', call: () => void): void;
  lookAt(pitch: number, yaw: number, hfov: number, animated: false): void;
  getConfig(): Readonly<Record<string, number>>;
}

/** The player with a picture in it. */
async function played(png: Uint8Array) {
  const visit = await program.open('player.html', { viewport: { width: 320, height: 240 } }, async (page) => {
    const body = `<!doctype html><link rel="icon" href="data:,"><style>${STYLE}</style>
      <body style="margin: 0"><div id="player" style="width: 320px; height: 240px"></div>
      <script>${SCRIPT}</script>`;
    await page.route('**/player.html', (route) => route.fulfill({ body, contentType: 'text/html' }));
    await page.route('**/around.png', (route) => route.fulfill({ body: Buffer.from(png), contentType: 'image/png' }));
  });
  await visit.page.evaluate(async () => {
    const page = window as unknown as PlayerWindow;
    const config = { type: 'equirectangular', panorama: 'around.png', autoLoad: true, showControls: false };
    page.player = page.pannellum.viewer('player', config);
    await new Promise<void>((loaded) => page.player.on('load', loaded));
  });
  return visit;
}

/** What is in the middle of the player when it looks there [°]; from a picture, once it is drawn. */
async function seen(page: Page, pitch: number, yaw: number): Promise<readonly number[]> {
  await page.evaluate(
    ([up, right]) => {
      (window as unknown as PlayerWindow).player.lookAt(up!, right!, 60, false);
      return new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    },
    [pitch, yaw],
  );
  const { data, channels } = decode(await page.screenshot());
  const at = channels * (120 * 320 + 160);
  return Array.from(data.slice(at, at + 3)).map((value) => 255 * Math.round(Number(value) / 255));
}

it('a whole sphere is seen in all directions', async () => {
  const visit = await played(
    withSphericalPng(picture([512, 256], 0, 0, 512, 256), { projection: 'equirectangular', stereo: 'none' }),
  );
  const { page } = visit;
  const config = await page.evaluate(() => (window as unknown as PlayerWindow).player.getConfig());
  expect(config).toMatchObject({ haov: 360, vaov: 180 });
  expect(config.vOffset).toBeCloseTo(0, 9);
  for (const [pitch, yaw, color] of [
    [0, 0, AHEAD],
    [0, 90, RIGHT],
    [0, -90, LEFT],
    [0, 180, BEHIND],
    [80, 0, ABOVE],
    [-80, 0, BELOW],
  ] as const)
    expect(await seen(page, pitch, yaw), `${pitch} ${yaw}`).toEqual(color);
  await visit.close();
});

it('a part of it is where the mark says, with its heading', async () => {
  const crop = { left: 0.25, right: 0.25, top: 0.125, bottom: 0.375 };
  const mark: SphericalPicture = { projection: 'equirectangular', stereo: 'none', crop, heading: Math.PI / 3 };
  const visit = await played(withSphericalPng(picture([512, 256], 128, 32, 256, 128), mark));
  const { page } = visit;
  const config = await page.evaluate(() => (window as unknown as PlayerWindow).player.getConfig());
  expect(config).toMatchObject({ haov: 180, vaov: 90, vOffset: 22.5, northOffset: 60 });
  expect(await seen(page, 0, 0)).toEqual(AHEAD);
  expect(await seen(page, 0, 50)).toEqual(RIGHT);
  expect(await seen(page, 55, 0)).toEqual(ABOVE);
  await visit.close();
});
