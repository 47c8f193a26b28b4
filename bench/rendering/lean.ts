import type { Shading } from '../../src/render/settings.ts';
import { type Bench, interleaved, type Table } from '../support/bench.ts';
import { gpu, openRenderer } from '../support/gpu.ts';
import { type MotionKind, sphereScene } from '../support/scenes.ts';
import { openPlainThree } from './plainThree.ts';

const SIZE = { width: 640, height: 360 };
const ROUNDS = 5;
/** As the page flies on a slow machine. */
const SETTINGS = { occlusionRadius: 0 };

export const lean: Bench = {
  name: 'lean',
  title: 'Forward ÷ deferred ÷ stock',
  about:
    'The scenes of *Frame time*, without ambient occlusion: *deferred*, by a G-buffer; *forward*, where the pass that draws the surfaces computes their light; *stock*, three’s own forward renderer as there. ' +
    'All three take turns. *Bytes a pixel*: all textures of the size of the picture that the renderer has made by then.',
  async run() {
    const rows: (string | number)[][] = [];
    for (const triangles of [100_000, 1_000_000])
      for (const kind of ['static', 'rigid', 'deforming'] as const) rows.push(await row(triangles, kind));
    const columns = ['triangles', 'motion', 'stock [ms]', 'deferred [ms]', 'forward [ms]'];
    const table: Table = {
      columns: [...columns, 'forward ÷ deferred', 'deferred ÷ stock', 'forward ÷ stock'],
      rows,
      remark: `On ${(await gpu()).adapterName}.`,
    };
    const memory: Table = { columns: ['shading', 'bytes a pixel'], rows: await memoryRows() };
    return [table, memory];
  },
};

async function openShaded(shading: Shading) {
  const { renderer, frame } = await openRenderer(SIZE.width, SIZE.height);
  renderer.shading = shading === 'forward' ? 'auto' : 'deferred';
  const draw = async (): Promise<void> => {
    await frame(SETTINGS);
    if (renderer.info.shading !== shading) throw new Error(`drawn ${renderer.info.shading}, not ${shading}`);
  };
  return { renderer, draw };
}

async function row(triangles: number, kind: MotionKind): Promise<(string | number)[]> {
  console.error(`  ${triangles.toLocaleString('en')} triangles, ${kind}`);
  const scene = sphereScene(triangles, kind);
  const stock = await openPlainThree(scene, SIZE.width, SIZE.height);
  const [deferred, forward] = [await openShaded('deferred'), await openShaded('forward')];
  for (const { renderer } of [deferred, forward]) await renderer.setScene(scene);
  const [bare, d, f] = await interleaved([stock.frame, deferred.draw, forward.draw], ROUNDS);
  const drawn = forward.renderer.info.triangles;
  for (const drawer of [stock, deferred.renderer, forward.renderer]) drawer.dispose();
  return [drawn.toLocaleString('en'), kind, bare, d, f, f / d, d / bare, f / bare];
}

/** Bytes of a texel, by format. */
const TEXEL_BYTES: Readonly<Record<string, number>> = {
  rgba32float: 16,
  rgba16float: 8,
  rg32float: 8,
  depth32float: 4,
  rgba8unorm: 4,
  r32float: 4,
};

async function memoryRows(): Promise<(string | number)[][]> {
  const rows: (string | number)[][] = [];
  const { device } = await gpu();
  for (const shading of ['deferred', 'forward'] as const) {
    const { createTexture } = device;
    let bytes = 0;
    device.createTexture = (descriptor) => {
      const [width, height] = sizeOf(descriptor.size);
      if (width === SIZE.width && height === SIZE.height) {
        const texel = TEXEL_BYTES[descriptor.format];
        if (texel === undefined) throw new Error(`no size of a texel of ${descriptor.format}`);
        bytes += texel;
      }
      return createTexture.call(device, descriptor);
    };
    const { renderer, draw } = await openShaded(shading);
    await renderer.setScene(sphereScene(1000, 'static'));
    await draw();
    renderer.dispose();
    device.createTexture = createTexture;
    rows.push([shading, bytes]);
  }
  return rows;
}

const sizeOf = (size: GPUExtent3D): readonly (number | undefined)[] =>
  'width' in size ? [size.width, size.height] : [...size];
