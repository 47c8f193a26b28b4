import { fileURLToPath } from 'node:url';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { addScaled } from '../../src/math/vec3.ts';
import { velocity } from '../../src/physics/lorentz/boost.ts';
import type { Sampling } from '../../src/render/settings.ts';
import type { ViewPoint } from '../../src/scene/view/view.ts';
import { speedOfLight } from '../../tests/examples/open.ts';
import { type CameraPath, FRAME_TIME, passing, temporalError, turning } from '../../tests/support/cameraPaths.ts';
import { renderSequence } from '../../tests/support/renderSequence.ts';
import { exampleFrame } from '../../tests/visual/frames.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { openRenderer, SETTINGS } from '../support/gpu.ts';
import { sphereScene, VIEW } from '../support/scenes.ts';

const SIZE = { width: 192, height: 108 };
const PICTURES = 5;
const ROUNDS = 5;
const WAYS: readonly (readonly [name: string, sampling: Sampling])[] = [
  ['edges (FXAA)', 1],
  ['temporal', 'temporal'],
  ['2 × 2', 2],
];

export const antialiasing: Bench = {
  name: 'antialiasing',
  title: 'Moving pictures against the truth',
  about:
    `Films of ${PICTURES} pictures, ${SIZE.width} × ${SIZE.height}, 1/30 s apart, after others, against the same pictures of 8 × 8 samples, in steps of 8 bits. *Error*: mean over all channels. *Flicker*: mean of what changes ` +
    'between two pictures and not in the truth. *Worst*: one channel in a thousand is farther off. A head that turns by a third of a pixel a picture over slats and posts finer than pixels, balls that pass before a fence, and the ' +
    'street, forward: as bad as it comes, for what is near grows by a tenth between two pictures and changes its D. Time: 100,000 triangles at rest, 640 × 360, both in turns.',
  async run() {
    const times = await cost();
    const rows: (string | number)[][] = [];
    for (const flight of [turning(0), turning(0.5), passing(), await street(0.5), await street(0.9)])
      rows.push(...(await rowsOf(flight)));
    const columns = ['flight', 'antialiasing', 'error', 'flicker', 'worst'];
    return [
      { columns, rows },
      { columns: ['edges (FXAA) [ms]', 'temporal [ms]', 'temporal ÷ edges'], rows: [times] },
    ];
  },
};

/** Coasting from the command line's default view of the example. */
async function street(beta: number): Promise<CameraPath> {
  const scene = await openSceneFile(fileURLToPath(new URL('../../../../examples/street.usdc', import.meta.url)));
  const { view, settings } = exampleFrame('street', scene, 'light-cone', beta);
  const c = speedOfLight(scene);
  const at = (index: number): ViewPoint => ({
    ...view,
    t: view.t + FRAME_TIME * index,
    position: addScaled(view.position, velocity(view.u), c * FRAME_TIME * index),
  });
  return { name: `street, ${beta} c`, scene, settings, view: at };
}

async function rowsOf(flight: CameraPath): Promise<(string | number)[][]> {
  console.error(`  ${flight.name}`);
  const { renderer } = await openRenderer(SIZE.width, SIZE.height);
  const film = (sampling: Sampling) => renderSequence(renderer, flight, sampling, PICTURES, pumpFrame);
  const truth = await film(8);
  const rows: (string | number)[][] = [];
  for (const [name, sampling] of WAYS) {
    const { error, flicker, worst } = temporalError(await film(sampling), truth);
    rows.push([flight.name, name, error, flicker, worst]);
  }
  renderer.dispose();
  return rows;
}

async function cost(): Promise<number[]> {
  const { renderer } = await openRenderer(640, 360);
  await renderer.setScene(sphereScene(100_000, 'static'));
  const draw = (sampling: Sampling) => async () => {
    pumpFrame();
    renderer.render([VIEW], SETTINGS, sampling);
    await renderer.readPixels();
  };
  const [edges, temporal] = await interleaved([draw(1), draw('temporal')], ROUNDS);
  renderer.dispose();
  return [edges, temporal, temporal / edges];
}
