import '../../../src/cli/gpu/nodeShim.ts';
import { expect } from 'vitest';
import { pumpFrame } from '../../../src/cli/gpu/nodeShim.ts';
import { cameraRay } from '../../../src/reference/camera/cameraRay.ts';
import type { TracedScene } from '../../../src/reference/intersection/tracedScene.ts';
import { pixelSequence } from '../../../src/reference/sampling/pixelSequence.ts';
import { radiance } from '../../../src/reference/transport/path.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { DIRECT } from '../../support/lightKit.ts';
import type { HeadlessPictures } from './openPictures.ts';

/** Every fourth pixel of every fourth row is compared. */
const STEP = 4;

/** Mean and greatest difference of two renderers over all channels, relative to the reference's brightest value. */
export interface Difference {
  readonly mean: number;
  readonly max: number;
}

/** For direct light of unoccluded distant and local lights; `samples`: rays of the reference per pixel. */
export async function compareWithReference(
  { renderer }: HeadlessPictures,
  scene: TracedScene,
  view: ViewPoint,
  settings: RenderSettings,
  samples: number,
): Promise<Difference> {
  await renderer.setScene({ ...scene.scene });
  pumpFrame();
  renderer.render([view], settings, 1);
  const drawn = await renderer.readAov('beauty');
  const { width, height } = renderer;
  const far: number[] = [];
  let brightest = 0;
  for (let y = 2; y < height; y += STEP)
    for (let x = 2; x < width; x += STEP) {
      const ray = cameraRay(view, settings, x + 0.5, y + 0.5, width, height)!;
      const numbers = pixelSequence(1, x, y);
      const sums = [0, 0, 0];
      for (let i = 0; i < samples; i++)
        radiance(scene, ray, view, settings, DIRECT, numbers(i)).forEach((value, k) => {
          sums[k] += value;
        });
      sums.forEach((sum, k) => {
        brightest = Math.max(brightest, sum / samples);
        far.push(Math.abs(drawn[3 * (y * width + x) + k] - sum / samples));
      });
    }
  expect(brightest).toBeGreaterThan(0);
  return { mean: far.reduce((a, b) => a + b) / far.length / brightest, max: Math.max(...far) / brightest };
}
