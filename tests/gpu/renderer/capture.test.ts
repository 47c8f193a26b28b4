import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';
import { CAPTURED, DIRECT, difference, picture, SCENE, SIZE, VIEWS } from './captureScenes.ts';

let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE.width, SIZE.height);
  await headless.renderer.setScene(SCENE);
});
afterAll(() => headless?.close());

it('prints', async () => {
  const { renderer } = headless;
  for (const [name, view] of Object.entries(VIEWS)) {
    const drawn = await picture(renderer, view, DIRECT, pumpFrame);
    const first = await picture(renderer, view, CAPTURED, pumpFrame);
    const again = await picture(renderer, view, CAPTURED, pumpFrame);
    console.log(name, drawn.triangles, first.triangles, again.triangles, difference(drawn, again));
  }
});
