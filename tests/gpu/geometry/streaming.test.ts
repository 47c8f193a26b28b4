import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type ModulePage, openModulePage } from '../support/modulePage.ts';
import { openPictures } from '../support/openPictures.ts';
import { FEW_TEXELS, renderStreamingViews, type SampleStorage, SIZE, STREAMING_VIEWS } from './streamingScenes.ts';

/** Every float of every picture of a long deforming mesh is the same, wherever its samples are stored. */
function checks(paint: (form: SampleStorage) => Promise<number[][]>): void {
  let whole: number[][];
  beforeAll(async () => {
    whole = await paint('whole');
  });

  it('the object is visible and changes', () => {
    expect(whole).toHaveLength(STREAMING_VIEWS.length);
    expect(new Set(whole.map((picture) => picture.join())).size).toBe(STREAMING_VIEWS.length);
  });

  for (const form of ['ring', 'file'] as const)
    it(`forward, backward and over a jump: ${form}`, async () => {
      expectSame(await paint(form), whole);
    });
}

function expectSame(seen: number[][], whole: number[][]): void {
  seen.forEach((picture, i) => {
    const wrong = picture.findIndex((x, k) => !Object.is(x, whole[i][k]));
    expect(wrong, `look ${i}: float ${wrong} is ${picture[wrong]}, not ${whole[i][wrong]}`).toBe(-1);
  });
}

describe('samples that stream: WebGPU (Dawn)', () => {
  checks(async (form) => {
    const headless = await openPictures(SIZE, SIZE, form === 'whole' ? {} : { maxPointTexels: FEW_TEXELS });
    const seen = await renderStreamingViews(headless.renderer, form);
    await headless.close();
    return seen;
  });
});

describe('samples that stream: WebGL2 (Chromium)', () => {
  let chromium: ModulePage;
  beforeAll(async () => {
    chromium = await openModulePage(fileURLToPath(new URL('./streamingPage.ts', import.meta.url)));
  });
  afterAll(() => chromium?.close());

  checks(async (form) => {
    const seen = await chromium.page.evaluate((name) => window.paintStreamed(name), form);
    chromium.assertHealthy();
    return seen;
  });

  it('with samples read by a worker pictures wait for them', async () => {
    // Tessellation is planned by another worker, so it is fixed in both.
    const paint = (form: SampleStorage) => chromium.page.evaluate((name) => window.paintStreamed(name, Infinity), form);
    expectSame(await paint('worker'), await paint('whole'));
    chromium.assertHealthy();
  });

  it('two views of one picture, whose samples do not fit together, are drawn as theirs arrive', async () => {
    const paint = (form: SampleStorage) => chromium.page.evaluate((name) => window.paintStreamedPair(name), form);
    expectSame([await paint('worker')], [await paint('whole')]);
    chromium.assertHealthy();
  });
});
