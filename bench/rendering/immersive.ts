import { fileURLToPath } from 'node:url';
import { openSceneFile } from '../../src/cli/files/sceneFiles.ts';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { rotate } from '../../src/math/quat.ts';
import { scale } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { observerFromCamera } from '../../src/scene/view/camera.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu, openRenderer, SETTINGS } from '../support/gpu.ts';

const SIZE = { width: 640, height: 360 };
const ROUNDS = 5;
/** The paper's three scenes, and one of Sponza's size. */
const SCENES = ['saturn', 'gallery', 'boxes', 'arcade'];
/** The three moments of an acceleration that it shows. */
const BETAS = [0.892, 0.949, 0.968];

export const immersive: Bench = {
  name: 'immersive',
  title: 'Scenes and speeds of the immersive paper, relativistic ÷ plain',
  about:
    'Our scenes of those that the paper on immersive relativistic environments measures (Saturn, a gallery, plain boxes), and an arcade of the size of Sponza, at its three speeds; 640 × 360 pixels. ' +
    '*Plain* is the same renderer with c = ∞ (`galilean`) from the same event. Both take turns; a frame ends when its pixels have been read back. At speed more of a scene is in the picture, and its edges are divided.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const name of SCENES) for (const beta of BETAS) rows.push(await row(name, beta));
    const { adapterName } = await gpu();
    const columns = ['scene', 'triangles', 'β', 'plain [ms]', 'relativistic [ms]', '÷ plain'];
    const remark = `On ${adapterName}. The paper has 1 for its three scenes with threads of their own for the transformation, and 1, 2.7 and 1.3 without.`;
    return [{ columns, rows, remark }];
  },
};

async function row(name: string, beta: number): Promise<(string | number)[]> {
  console.error(`  immersive, ${name}, ${beta} c`);
  const scene = await openSceneFile(fileURLToPath(new URL(`../../../../examples/${name}.usdc`, import.meta.url)));
  const c = scene.hints.speedOfLight ?? 1;
  const t = scene.hints.openAt ?? scene.startTime;
  const seen = { t, ...observerFromCamera(scene.cameras[0], t, c) };
  const view = { ...seen, u: properVelocity(scale(rotate(seen.orientation, [0, 0, -1]), beta)) };
  const { renderer } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(scene);
  const draw = (change: Partial<RenderSettings>) => async (): Promise<void> => {
    pumpFrame();
    renderer.render([view], { ...SETTINGS, speedOfLight: c, ...change });
    await renderer.readPixels();
  };
  const [plain, relativistic] = await interleaved([draw({ view: 'galilean' }), draw({})], ROUNDS);
  renderer.dispose();
  const triangles = scene.objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
  return [name, triangles.toLocaleString('en'), beta, plain, relativistic, relativistic / plain];
}
