import type { SphereLight } from '../../src/scene/types.ts';
import type { Bench, Table } from '../support/bench.ts';
import { interleaved } from '../support/bench.ts';
import { gpu, openRenderer } from '../support/gpu.ts';
import { type MotionKind, sphereScene, VIEW } from '../support/scenes.ts';
import { openPlainThree } from './plainThree.ts';

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
    const lamps: (string | number)[][] = [];
    for (const kind of ['static', 'rigid'] as const)
      for (const count of [1, 4]) lamps.push(await lampRow(100_000, kind, count));
    const skies: (string | number)[][] = [];
    for (const kind of ['static', 'rigid'] as const) skies.push(await occlusionRow(100_000, kind));
    const columns = ['triangles', 'motion', 'stock [ms]', 'plain [ms]', 'relativistic [ms]', '÷ plain', '÷ stock'];
    const table: Table = { columns, rows, remark: `On ${adapterName}.` };
    return [
      table,
      { columns: COLOR_COLUMNS, rows: colors, remark: COLOR_REMARK },
      { columns: SHADOW_COLUMNS, rows: shadows, remark: SHADOW_REMARK },
      { columns: LAMP_COLUMNS, rows: lamps, remark: LAMP_REMARK },
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

/** Cost of Doppler colours. */
async function colorRow(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  colours, ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(sphereScene(triangles, kind));
  const works = [() => frame({ dopplerMix: 0, beaming: 0 }), () => frame({ colors: 'approximate' }), () => frame()];
  const [off, approximate, spectral] = await interleaved(works, ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, off, approximate, spectral, approximate / off, spectral / off];
}

const SHADOW_COLUMNS = ['triangles', 'motion', 'detail', 'off [ms]', 'on [ms]', 'on ÷ off'];
const SHADOW_REMARK =
  'Shadows of one sun; *coarse* is what the page has on a software GPU, *fine* all else. From picture to picture 0.02 s pass, so that what moves is drawn into its shadow map for each; the map of what rests is drawn once.';

/** Cost of shadows. */
async function shadowRow(
  triangles: number,
  kind: MotionKind,
  shadowDetail: 'coarse' | 'fine',
): Promise<(string | number)[]> {
  console.error(`  shadows, ${triangles.toLocaleString('en')} triangles, ${kind}, ${shadowDetail}`);
  const opened = await openRenderer(SIZE.width, SIZE.height, { shadowDetail });
  await opened.renderer.setScene(sphereScene(triangles, kind));
  const [drawn, off, on] = await withoutAndWith(opened);
  return [drawn, kind, shadowDetail, off, on, on / off];
}

/** Number of triangles, and times of pictures without and with shadows [ms], with advancing scene time. Disposes of the renderer. */
async function withoutAndWith({ renderer, frame }: Awaited<ReturnType<typeof openRenderer>>) {
  let t = VIEW.t;
  const works = [false, true].map((shadows) => () => {
    t += 0.02;
    return frame({ shadows }, { t });
  });
  const [off, on] = await interleaved(works, 2 * ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), off, on] as const;
}

const LAMP_COLUMNS = ['triangles', 'motion', 'lamps', 'off [ms]', 'on [ms]', 'on ÷ off'];
const LAMP_REMARK =
  'Shadows of resting lamps of 0.2 m, fine, with time going on as above: where things rest each lamp has six tiles, which are drawn once; where they move each has tiles of the bodies that it shines on, drawn for every picture.';

/** Cost of shadows of local lights. */
async function lampRow(triangles: number, kind: MotionKind, count: number): Promise<(string | number)[]> {
  console.error(`  shadows of ${count} lamps, ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const opened = await openRenderer(SIZE.width, SIZE.height);
  await opened.renderer.setScene({
    ...sphereScene(triangles, kind),
    lights: Array.from({ length: count }, (_, k) => lampAt(k)),
  });
  const [drawn, off, on] = await withoutAndWith(opened);
  return [drawn, kind, String(count), off, on, on / off];
}

const lampAt = (k: number): SphereLight => ({
  kind: 'sphere',
  path: `/Lamp${k}`,
  motion: { kind: 'static', pose: { position: [4 * k - 6, 3, -6], orientation: [0, 0, 0, 1] } },
  lifetime: { birth: Number.NEGATIVE_INFINITY, death: Number.POSITIVE_INFINITY },
  radius: 0.1,
  color: [300, 300, 300],
});

const OCCLUSION_COLUMNS = ['triangles', 'motion', 'off [ms]', 'on [ms]', 'on ÷ off'];
const OCCLUSION_REMARK =
  'Ambient occlusion: *off* is the same picture with a radius of 0, for which none of it runs. Where things move, each neighbour is followed to the event at which the ' +
  "point's light passed it. The page leaves it out while a slow machine flies at its lowest resolution.";

/** Cost of ambient occlusion. */
async function occlusionRow(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  occlusion, ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(sphereScene(triangles, kind));
  const [off, on] = await interleaved([() => frame({ occlusionRadius: 0 }), () => frame()], ROUNDS);
  const drawn = renderer.info.triangles;
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, off, on, on / off];
}

async function row(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const scene = sphereScene(triangles, kind);
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  await renderer.setScene(scene);
  const stock = await openPlainThree(scene, SIZE.width, SIZE.height);
  const works = [stock.frame, () => frame({ view: 'galilean' }), () => frame()];
  const [bare, plain, relativistic] = await interleaved(works, ROUNDS);
  const drawn = renderer.info.triangles;
  stock.dispose();
  renderer.dispose();
  return [drawn.toLocaleString('en'), kind, bare, plain, relativistic, relativistic / plain, relativistic / bare];
}
