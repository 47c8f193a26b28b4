import '../../../src/cli/gpu/nodeShim.ts';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { type FilmDomeCase, type FilmDomePictures, filmDomePictures, SIZE } from './filmDomeScenes.ts';

let headless: HeadlessPictures;
let page: ModulePage | undefined;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(async () => {
  await headless?.close();
  await page?.close();
});

async function pictures(given: FilmDomeCase, backend: 'Dawn' | 'WebGL2'): Promise<FilmDomePictures> {
  if (backend === 'Dawn') return filmDomePictures(headless.renderer, given, pumpFrame);
  page ??= await openModulePage(fileURLToPath(new URL('./filmDomePage.ts', import.meta.url)));
  const found = await page.page.evaluate((asked) => window.filmDomePictures(asked), given);
  page.assertHealthy();
  return found;
}

/** How many numbers of two pictures differ. */
const others = (a: readonly number[], b: readonly number[]): number => {
  expect(a.length).toBe(b.length);
  return a.filter((value, i) => value !== b[i]).length;
};

describe.each(['Dawn', 'WebGL2'] as const)('a frame that is shown on a dome on %s', (backend) => {
  it.each([
    ['all is at rest', { velocity: [0, 0, 0], means: 'none' }],
    ['something glossy moves', { velocity: [0.5, 0.2, -0.4], means: 'fine' }],
  ] as const)('is, to the bit, as if the scene had been opened with it: %s', async (_, given) => {
    const { opened, shown, early, again } = await pictures(given, backend);
    expect(opened[0].every(Number.isFinite)).toBe(true);
    // In nearly all of the picture the frames differ: three of the seven numbers of a pixel are radiance.
    expect(others(opened[0], opened[1])).toBeGreaterThan(0.7 * (6 / 7) * opened[0].length);
    expect(shown.map((picture) => others(picture, opened[1]))).toEqual([0, others(...opened), 0]);
    expect(others(shown[1]!, opened[0])).toBe(0);
    expect(others(early, opened[1])).toBe(0);
    expect(others(again, opened[0])).toBe(0);
  });
});
