import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { addScaled, cross, dot, normalize, scale, type Vec3 } from '../../../src/math/vec3.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import { latLongFromDirection } from '../../../src/scene/lights/latLong.ts';
import { sampleTexture } from '../../../src/scene/materials/sampleTexture.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import {
  COLUMNS,
  drawnPanorama,
  H,
  LINES,
  type PanoramaFlight,
  panorama,
  pastLines,
  ROWS,
  ripples,
  SETTINGS,
  viewOf,
  W,
} from './panoramaScenes.ts';

let headless: HeadlessPictures;
let page: ModulePage | undefined;
beforeAll(async () => {
  headless = await openPictures(W, H);
});
afterAll(async () => {
  await headless?.close();
  await page?.close();
});

async function drawn(flight: PanoramaFlight, backend: 'Dawn' | 'WebGL2'): Promise<number[]> {
  if (backend === 'Dawn') {
    pumpFrame();
    return drawnPanorama(headless.renderer, flight);
  }
  page ??= await openModulePage(fileURLToPath(new URL('./panoramaPage.ts', import.meta.url)));
  const values = await page.page.evaluate((given) => window.drawnPanorama(given), flight);
  page.assertHealthy();
  return values;
}

/** Pixels that are compared, and means of 8 × 8 rays of the reference in each, of `at` by their world direction. */
function means(flight: PanoramaFlight, at: (n: Vec3) => number): { readonly pixel: number; readonly mean: number }[] {
  const view = viewOf(flight);
  const found: { pixel: number; mean: number }[] = [];
  for (let y = 1; y < H; y += 3)
    for (let x = 1; x < W; x += 3) {
      let mean = 0;
      for (let k = 0; k < 64; k++) {
        const [dx, dy] = [((k % 8) + 0.5) / 8, (Math.floor(k / 8) + 0.5) / 8];
        mean += at(normalize(cameraRay(view, SETTINGS, x + dx, y + dy, W, H)!.dx)) / 64;
      }
      found.push({ pixel: y * W + x, mean });
    }
  return found;
}

const AHEAD = { along: [0, 0, -1], forward: [0, 0, -1], up: [0, 1, 0] } as const;
const TO_THE_POLE = { along: [0, 0, -1], forward: [0, 1, 0], up: [0, 0, 1] } as const;
const POLE_AHEAD = { along: [0, 1, 0], forward: [0, 1, 0], up: [0, 0, 1] } as const;

describe.each(['Dawn', 'WebGL2'] as const)('a panorama on %s', (backend) => {
  it.each([
    [0, AHEAD],
    [0.9, AHEAD],
    [0.99, AHEAD],
    [0, TO_THE_POLE],
    [0.9, TO_THE_POLE],
    [0.9, POLE_AHEAD],
  ] as const)('one sample shows what 8 × 8 show of noise, to 3.5 % a pixel: %s c, %o', async (beta, directions) => {
    const flight: PanoramaFlight = { content: 'noise', beta, ...directions };
    const { texture } = panorama('noise');
    const picture = await drawn(flight, backend);
    const expected = means(flight, (n) => sampleTexture(texture, ...latLongFromDirection(n))[0]);
    const mean = expected.reduce((sum, { mean }) => sum + mean, 0) / expected.length;
    const squares = expected.reduce((sum, { pixel, mean }) => sum + (picture[pixel] - mean) ** 2, 0);
    const error = Math.sqrt(squares / expected.length) / mean;
    if (process.env.REPORT) console.log(backend, beta, directions.forward, error.toFixed(4));
    expect(error).toBeLessThan(0.035);
  });

  it('many samples show what they cover together, no more: their mean is as sharp as that of rays', async () => {
    const flight: PanoramaFlight = { content: 'noise', beta: 0.9, ...AHEAD, samples: 8 };
    const { texture } = panorama('noise');
    const picture = await drawn(flight, backend);
    const expected = means(flight, (n) => sampleTexture(texture, ...latLongFromDirection(n))[0]);
    const mean = expected.reduce((sum, { mean }) => sum + mean, 0) / expected.length;
    const squares = expected.reduce((sum, { pixel, mean }) => sum + (picture[pixel] - mean) ** 2, 0);
    const error = Math.sqrt(squares / expected.length) / mean;
    if (process.env.REPORT) console.log(backend, '8 × 8', error.toFixed(4));
    expect(error).toBeLessThan(0.003);
  });

  it.each([
    ['parallels', 0],
    ['parallels', 0.9],
    ['parallels', 0.99],
    ['meridians', 0],
    ['meridians', 0.9],
    ['meridians', 0.99],
  ] as const)(
    'lines one texel wide are where aberration has them, to half a pixel: %s at %s c',
    async (content, beta) => {
      const flight = pastLines(content, beta);
      const { along, side, forward, up } = flight;
      const picture = (await drawn(flight, backend)).slice(Math.floor(H / 2) * W, (Math.floor(H / 2) + 1) * W);
      const tanX = (Math.tan(flight.fovY! / 2) * W) / H;
      const right = cross(forward, normalize(up));
      const places = LINES.flatMap((line) => {
        const angle =
          content === 'parallels' ? (Math.PI * (line + 0.5)) / ROWS : (2 * Math.PI * (line + 0.5)) / COLUMNS;
        const cosine = (Math.cos(angle) + beta) / (1 + beta * Math.cos(angle));
        const n = addScaled(scale(along, cosine), side, Math.sqrt(1 - cosine ** 2));
        const x = (W / 2) * (1 + dot(n, right) / dot(n, forward) / tanX);
        return dot(n, forward) > 0 && x > 4 && x < W - 4 ? [x] : [];
      }).sort((a, b) => a - b);
      expect(places.length).toBeGreaterThan(2);
      for (const [i, place] of places.entries()) {
        const [before, after] = [places[i - 1] ?? 0, places[i + 1] ?? W].map((other) => (place + other) / 2);
        let [sum, moment] = [0, 0];
        for (let x = Math.ceil(Math.max(before, place - 8)); x < Math.min(after, place + 8); x++) {
          sum += picture[x];
          moment += picture[x] * (x + 0.5);
        }
        if (process.env.REPORT)
          console.log(backend, content, beta, place.toFixed(2), (moment / sum - place).toFixed(3));
        expect(Math.abs(moment / sum - place)).toBeLessThan(0.5);
      }
    },
  );

  it.each([
    ['its edges meet', 0, AHEAD],
    ['its edges meet', 0.9, AHEAD],
    ['it has a pole', 0, TO_THE_POLE],
    ['it has a pole', 0.9, TO_THE_POLE],
    ['it has a pole', 0.9, POLE_AHEAD],
  ] as const)('nothing shows where %s: %s c, %o', async (_, beta, directions) => {
    const flight: PanoramaFlight = { content: 'ripples', beta, ...directions };
    const picture = await drawn(flight, backend);
    const most = Math.max(...means(flight, ripples).map(({ pixel, mean }) => Math.abs(picture[pixel] - mean)));
    if (process.env.REPORT) console.log(backend, beta, directions.forward, most.toFixed(4));
    expect(most).toBeLessThan(0.02);
  });
});
