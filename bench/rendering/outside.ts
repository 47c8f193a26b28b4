import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { orbitCamera } from '../../src/scene/view/outsideCamera.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu, openRenderer, SETTINGS } from '../support/gpu.ts';
import { type MotionKind, sphereScene, VIEW } from '../support/scenes.ts';

const SIZE = { width: 640, height: 360 };
const OUTSIDE = { width: 336, height: 210 };
const TRIANGLES = 100_000;
const ROUNDS = 7;
/** The world now, the observer with his rings, and the contours of what he sees, as the page shows them. */
const FROM_OUTSIDE: RenderSettings = {
  ...SETTINGS,
  ...{ view: 'galilean', aberration: false, dopplerMix: 0, beaming: 0, ghost: 'light-cone', occlusionRadius: 0 },
  outside: orbitCamera({ distance: 30, azimuth: 0.5, elevation: 0.55, fovY: 0.8 }, [0, 1, 0]),
  frameGraph: {
    extraBuffers: [],
    passes: [
      { kind: 'light', buffer: 0, shadows: true, occlusion: false },
      { kind: 'effect', effect: 'observer-marks', args: [1, 0.8, 5], image: 0, buffer: 0 },
    ],
  },
};

export const outside: Bench = {
  name: 'outside',
  title: 'A picture with its outside view ÷ alone',
  about:
    'A picture of 640 × 360 pixels alone, and with an outside view of 336 × 210 by a renderer beside it, with the contours of what is seen. Between pictures 0.02 s pass. ' +
    'The page draws the outside view less often than the picture; here both are drawn each time.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const kind of ['static', 'rigid', 'deforming'] as const) rows.push(await row(kind));
    const { adapterName } = await gpu();
    const columns = ['motion', 'alone [ms]', 'with its outside view [ms]', 'with ÷ alone'];
    return [{ columns, rows, remark: `On ${adapterName}.` }];
  },
};

async function row(kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  outside, ${kind}`);
  const scene = sphereScene(TRIANGLES, kind);
  const { renderer } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(scene);
  const beside = renderer.beside();
  beside.setSize(OUTSIDE.width, OUTSIDE.height);
  await beside.setScene(scene);
  await beside.precompile([VIEW], FROM_OUTSIDE);
  let t = VIEW.t;
  const alone = async () => {
    t += 0.02;
    pumpFrame();
    renderer.render([{ ...VIEW, t }], SETTINGS);
    await renderer.readPixels();
  };
  const both = async () => {
    await alone();
    beside.render([{ ...VIEW, t }], FROM_OUTSIDE);
    await beside.readPixels();
  };
  const [one, two] = await interleaved([alone, both], ROUNDS);
  beside.dispose();
  renderer.dispose();
  return [kind, one, two, two / one];
}
