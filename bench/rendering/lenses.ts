import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import { domeLens } from '../../src/scene/view/lenses/fisheyeLens.ts';
import type { Lens } from '../../src/scene/view/lenses/lenses.ts';
import type { ViewPoint } from '../../src/scene/view/view.ts';
import { type Bench, interleaved } from '../support/bench.ts';
import { gpu, openRenderer, SETTINGS } from '../support/gpu.ts';
import { type MotionKind, sphereScene, VIEW } from '../support/scenes.ts';

const TRIANGLES = 100_000;
const ROUNDS = 5;
const PLAIN = { ...SETTINGS, occlusionRadius: 0 };
/** All of about as many pixels. */
const LENSES: readonly { readonly name: string; readonly lens: Lens; readonly size: readonly [number, number] }[] = [
  { name: 'equirectangular', lens: { kind: 'equirectangular' }, size: [672, 336] },
  { name: 'dome', lens: domeLens(Math.PI, 0), size: [475, 475] },
  { name: 'cube', lens: { kind: 'cube', layout: '3x2' }, size: [582, 388] },
  { name: 'stereo', lens: { kind: 'stereo', separation: 0.063 }, size: [476, 476] },
];
const PERSPECTIVE = [634, 356] as const;

export const lenses: Bench = {
  name: 'lenses',
  title: 'Panoramic pictures ÷ a perspective one',
  about:
    'Pictures of about 226,000 pixels each, of 100,000 triangles at 0.9 c, without occlusion: an equirectangular one, a dome master, a cube and a stereo one, put together of faces or strips, and a perspective one with the view of the other benchmarks. Between pictures 0.02 s pass.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const kind of ['static', 'rigid', 'deforming'] as const) rows.push(...(await rowsOf(kind)));
    const { adapterName } = await gpu();
    const columns = ['motion', 'lens', 'perspective [ms]', 'with the lens [ms]', 'lens ÷ perspective'];
    return [{ columns, rows, remark: `On ${adapterName}.` }];
  },
};

async function rowsOf(kind: MotionKind): Promise<(string | number)[][]> {
  const rows: (string | number)[][] = [];
  const scene = sphereScene(TRIANGLES, kind);
  const { renderer: plain } = await openRenderer(...PERSPECTIVE);
  await plain.setScene(scene);
  for (const { name, lens, size } of LENSES) {
    console.error(`  lenses, ${kind}, ${name}`);
    const { renderer } = await openRenderer(...size);
    await renderer.setScene(scene);
    let t = VIEW.t;
    const drawn = (by: typeof renderer, view: ViewPoint) => async () => {
      t += 0.02;
      pumpFrame();
      by.render([{ ...view, t }], PLAIN);
      await by.readPixels();
    };
    const [alone, around] = await interleaved([drawn(plain, VIEW), drawn(renderer, { ...VIEW, lens })], ROUNDS);
    rows.push([kind, name, alone, around, around / alone]);
    renderer.dispose();
  }
  plain.dispose();
  return rows;
}
