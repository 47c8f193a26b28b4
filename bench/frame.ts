import type { Bench, Table } from './bench.ts';
import { interleaved } from './bench.ts';
import { gpu, openRenderer } from './gpu.ts';
import { ballScene, type MotionKind, VIEW } from './scenes.ts';
import { openStock } from './stock.ts';

const SIZE = { width: 640, height: 360 };
const ROUNDS = 5;

export const frame: Bench = {
  name: 'frame',
  title: 'Frame time, relativistic ÷ plain',
  about:
    'Eight spheres, 640 × 360, observer at 0.5 c, objects up to 0.5 c, sampled ones with 250 samples; a frame ends when its pixels have been read back. ' +
    '*Plain* is the same renderer, G-buffer and lighting with c = ∞ (`galilean`): the difference is the light cone, the boost and the Doppler factor alone. ' +
    "*Stock* is three's own forward renderer with MeshStandardMaterial, one sun and a hemisphere light, and the objects at rest: it has no sampled motion, and no G-buffer, " +
    'so that ratio also holds what those cost. All three take turns.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const triangles of [100_000, 1_000_000]) {
      for (const kind of ['static', 'rigid', 'deforming'] as const) rows.push(await row(triangles, kind));
    }
    const { adapterName } = await gpu();
    const colors: (string | number)[][] = [];
    for (const kind of ['static', 'rigid'] as const) colors.push(await colorRow(100_000, kind));
    const shadows: (string | number)[][] = [];
    for (const kind of ['static', 'rigid'] as const)
      for (const detail of ['coarse', 'fine'] as const) shadows.push(await shadowRow(100_000, kind, detail));
    const skies: (string | number)[][] = [];
    for (const kind of ['static', 'rigid'] as const) skies.push(await occlusionRow(100_000, kind));
    const columns = ['triangles', 'motion', 'stock [ms]', 'plain [ms]', 'relativistic [ms]', '÷ plain', '÷ stock'];
    const table: Table = { columns, rows, remark: `On ${adapterName}.` };
    return [
      table,
      { columns: COLOR_COLUMNS, rows: colors, remark: COLOR_REMARK },
      { columns: SHADOW_COLUMNS, rows: shadows, remark: SHADOW_REMARK },
      { columns: OCCLUSION_COLUMNS, rows: skies, remark: OCCLUSION_REMARK },
    ];
  },
};

const COLOR_COLUMNS = [
  'triangles',
  'motion',
  'off [ms]',
  'approximate [ms]',
  'spectral [ms]',
  'approximate ÷ off',
  'spectral ÷ off',
];
const COLOR_REMARK =
  'Colour and beaming: *off* is the same picture, Doppler mix and beaming 0, for which their code is left out of the shaders; *approximate* the tint. ' +
  'Things at rest need one look-up of the table for a pixel, moving ones one more for each direction that light comes from, and one for its colour.';

/** What colours cost. */
async function colorRow(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  colours, ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(ballScene(triangles, kind));
  const works = [() => frame({ dopplerMix: 0, beaming: 0 }), () => frame({ colors: 'approximate' }), () => frame()];
  const [off, approximate, spectral] = await interleaved(works, ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, off, approximate, spectral, approximate / off, spectral / off];
}

const SHADOW_COLUMNS = ['triangles', 'motion', 'detail', 'off [ms]', 'on [ms]', 'on ÷ off'];
const SHADOW_REMARK =
  'Shadows of one sun; *coarse* is what the page has on a software GPU, *fine* all else. From picture to picture 0.02 s pass, so that what moves is drawn into its shadow map for each; the map of what rests is drawn once.';

/** What shadows cost. */
async function shadowRow(
  triangles: number,
  kind: MotionKind,
  shadowDetail: 'coarse' | 'fine',
): Promise<(string | number)[]> {
  console.error(`  shadows, ${triangles.toLocaleString('en')} triangles, ${kind}, ${shadowDetail}`);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height, { shadowDetail });
  await renderer.setScene(ballScene(triangles, kind));
  let t = VIEW.t;
  const works = [false, true].map((shadows) => () => {
    t += 0.02;
    return frame({ shadows }, { t });
  });
  const [off, on] = await interleaved(works, 2 * ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, shadowDetail, off, on, on / off];
}

const OCCLUSION_COLUMNS = ['triangles', 'motion', 'off [ms]', 'on [ms]', 'on ÷ off'];
const OCCLUSION_REMARK =
  'Ambient occlusion: *off* is the same picture with a radius of 0, for which none of it runs. Where things move, each neighbour is followed to the event at which the ' +
  "point's light passed it. The page leaves it out while a slow machine flies at its lowest resolution.";

/** What it costs that things hide the sky from each other. */
async function occlusionRow(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  occlusion, ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(ballScene(triangles, kind));
  const [off, on] = await interleaved([() => frame({ occlusionRadius: 0 }), () => frame()], ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, off, on, on / off];
}

async function row(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const scene = ballScene(triangles, kind);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(scene);
  const stock = await openStock(scene, SIZE.width, SIZE.height);
  const works = [stock.frame, () => frame({ view: 'galilean' }), () => frame()];
  const [bare, plain, relativistic] = await interleaved(works, ROUNDS);
  const drawn = renderer.info.triangles;
  stock.dispose();
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, bare, plain, relativistic, relativistic / plain, relativistic / bare];
}
