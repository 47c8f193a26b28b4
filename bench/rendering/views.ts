import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import type { PictureViews } from '../../src/scene/view/pictureViews.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu, openRenderer, SETTINGS } from '../support/gpu.ts';
import { type MotionKind, sphereScene, VIEW } from '../support/scenes.ts';

const SIZE = { width: 640, height: 360 };
const TRIANGLES = 100_000;
const ROUNDS = 7;
/** Half the distance between the eyes [m]. */
const HALF_BASE = 0.032;

export const views: Bench = {
  name: 'views',
  title: 'Two views ÷ one',
  about:
    'The same picture of 640 × 360 pixels with one view, and with the two of a stereo pair side by side, each with half of the pixels and an event of its own. ' +
    'Between pictures 0.02 s pass. What both eyes cost more is preparing the scene twice: object tables, tessellation plans, shadow maps.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const kind of ['static', 'rigid', 'deforming'] as const) rows.push(await row(kind));
    const { adapterName } = await gpu();
    return [{ columns: ['motion', 'one [ms]', 'two [ms]', 'two ÷ one'], rows, remark: `On ${adapterName}.` }];
  },
};

function stereo(t: number): PictureViews {
  const width = SIZE.width / 2;
  const eye = (side: -1 | 1) => ({
    ...VIEW,
    t,
    position: [VIEW.position[0] + side * HALF_BASE, VIEW.position[1], VIEW.position[2]] as const,
    viewport: { x: side < 0 ? 0 : width, y: 0, width, height: SIZE.height },
  });
  return [eye(-1), eye(1)];
}

async function row(kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  views, ${kind}`);
  const scene = sphereScene(TRIANGLES, kind);
  let t = VIEW.t;
  const drawing = async (viewsNow: () => PictureViews) => {
    // A renderer of its own: changing the number of views makes targets anew, and drivers then compile the shaders again.
    const { renderer } = await openRenderer(SIZE.width, SIZE.height);
    await renderer.setScene(scene);
    const draw = async () => {
      t += 0.02;
      pumpFrame();
      renderer.render(viewsNow(), SETTINGS);
      await renderer.readPixels();
    };
    return { renderer, draw };
  };
  const both = [await drawing(() => [{ ...VIEW, t }]), await drawing(() => stereo(t))];
  const [one, two] = await interleaved(
    both.map(({ draw }) => draw),
    ROUNDS,
  );
  for (const { renderer } of both) renderer.dispose();
  return [kind, one, two, two / one];
}
