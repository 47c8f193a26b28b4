import '../../../src/cli/gpu/nodeShim.ts';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { IDENTITY } from '../../../src/math/quat.ts';
import { ZERO } from '../../../src/math/vec3.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { sampleTexture } from '../../../src/scene/materials/sampleTexture.ts';
import { plane } from '../../../src/scene/mesh/primitives.ts';
import type { Texture, TextureWrap } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import { GREY } from '../../support/lightKit.ts';
import { type HeadlessPictures, openPictures } from '../support/openPictures.ts';

const SIZE = 64;
let headless: HeadlessPictures;
beforeAll(async () => {
  headless = await openPictures(SIZE, SIZE);
});
afterAll(() => headless?.close());

const checks = (wrapS: TextureWrap, wrapT: TextureWrap): Texture => ({
  name: 'checks',
  width: 2,
  height: 2,
  data: Uint8Array.of(255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255),
  colorSpace: 'linear',
  filter: 'linear',
  wrapS,
  wrapT,
});

/** A plane that fills the picture, with uvs from −1 to 2. */
async function drawn(texture: Texture): Promise<Float32Array> {
  const mesh = plane(2, 2);
  const wide = { ...mesh, uvs: mesh.uvs.map((x) => 3 * x - 1) };
  const scene = makeScene({
    name: 'textured',
    objects: [makeObject({ path: '/wall', mesh: wide, motion: restingAt([0, 0, -1]) })],
    materials: [makeMaterial({ name: 'm', baseColor: [1, 1, 1], baseColorTexture: texture })],
  });
  await headless.renderer.setScene(scene);
  pumpFrame();
  const view = { t: 0, position: ZERO, u: ZERO, orientation: IDENTITY, lens: perspective(Math.PI / 2) };
  headless.renderer.render([view], GREY, 1);
  return headless.renderer.readAov('albedo');
}

it.each([
  ['black', 'repeat'],
  ['clamp', 'black'],
  ['mirror', 'black'],
] as const)('a texture with wrap modes %s and %s agrees with the reference', async (wrapS, wrapT) => {
  const texture = checks(wrapS, wrapT);
  const albedo = await drawn(texture);
  let worst = 0;
  for (let y = 0; y < SIZE; y++)
    for (let x = 0; x < SIZE; x++) {
      const [u, v] = [(3 * (x + 0.5)) / SIZE - 1, 2 - (3 * (y + 0.5)) / SIZE];
      const expected = sampleTexture(texture, u, v);
      for (let k = 0; k < 3; k++) worst = Math.max(worst, Math.abs(albedo[3 * (y * SIZE + x) + k] - expected[k]));
    }
  expect(worst).toBeLessThan(0.02);
});
