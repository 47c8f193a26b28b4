import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { DEFAULT_CAPTURE } from '../../src/scene/view/capture.ts';
import { captureTexels } from '../../src/scene/view/captureBounds.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu, openRenderer, SETTINGS } from '../support/gpu.ts';
import { type MotionKind, sphereScene, VIEW } from '../support/scenes.ts';

const TRIANGLES = [100_000, 1_000_000];
const ROUNDS = 3;
const SIZE = [640, 360] as const;
const BYTES_PER_TEXEL = 64;
const DIRECT: RenderSettings = SETTINGS;
const CAPTURED: RenderSettings = { ...SETTINGS, capture: DEFAULT_CAPTURE };

const SIDE = captureTexels(DEFAULT_CAPTURE, VIEW, { width: SIZE[0], height: SIZE[1] });

export const capture: Bench = {
  name: 'capture',
  title: 'Pictures from a capture ÷ drawn ones',
  about: `Pictures of ${SIZE.join(' × ')} pixels at one event, at velocities about 0.9 c that change from picture to picture, as they are drawn and as they are taken from a capture; and a picture whose capture is drawn first, into new targets.`,
  async run() {
    const rows: (string | number)[][] = [];
    for (const kind of ['static', 'rigid', 'deforming'] as const)
      for (const triangles of TRIANGLES) rows.push(await rowOf(kind, triangles));
    const { adapterName } = await gpu();
    const columns = [
      'motion',
      'triangles',
      'drawn [ms]',
      'from a capture [ms]',
      'from a capture ÷ drawn',
      'with its capture [ms]',
    ];
    const mebibytes = ((6 * SIDE ** 2 * BYTES_PER_TEXEL) / 2 ** 20).toFixed(0);
    return [{ columns, rows, remark: `On ${adapterName}. Six faces of ${SIDE} pixels: ${mebibytes} MiB.` }];
  },
};

/** Captures of another size are drawn anew. */
const resized = (picture: number): RenderSettings => ({
  ...DIRECT,
  capture: { ...DEFAULT_CAPTURE, texels: SIDE + (picture % 2) },
});

async function rowOf(kind: MotionKind, triangles: number): Promise<(string | number)[]> {
  console.error(`  capture, ${kind}, ${triangles}`);
  const scene = sphereScene(triangles, kind);
  const renderers = await Promise.all([DIRECT, CAPTURED, CAPTURED].map(() => openRenderer(...SIZE)));
  for (const { renderer } of renderers) await renderer.setScene(scene);
  let picture = 0;
  const [drawn, captured, renewed] = [DIRECT, CAPTURED, CAPTURED].map((settings, i) => async () => {
    const { renderer } = renderers[i]!;
    picture++;
    const u = properVelocity([0, 0.01 * (picture % 7), -0.9]);
    pumpFrame();
    renderer.render([{ ...VIEW, u }], i === 2 ? resized(picture) : settings);
    await renderer.readPixels();
  });
  const times = await interleaved([drawn!, captured!, renewed!], ROUNDS);
  for (const { renderer } of renderers) renderer.dispose();
  return [kind, triangles, times[0]!, times[1]!, times[1]! / times[0]!, times[2]!];
}
