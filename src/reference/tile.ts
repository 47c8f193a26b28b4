import { AOVS, type DataAov } from '../scene/view/view.ts';
import { aovReader } from './aov.ts';
import { fillBeauty } from './beauty.ts';
import { cameraRay } from './camera/cameraRay.ts';
import { visibleHit } from './camera/visibleHit.ts';
import type { TracedScene } from './intersection/tracedScene.ts';
import type { ImageTile, OutputLayer, TileData, TileRequest } from './tileRequest.ts';

export function channelsOf(layer: OutputLayer): number {
  if (layer === 'denoiser_input') return 9;
  return layer === 'picture' ? 3 : AOVS[layer].channels.length;
}

/** Layers that depend on the samples of a pixel. */
const SAMPLED = ['beauty', 'picture', 'denoiser_input', 'sample_count'] as const satisfies readonly OutputLayer[];

/**
 * Renders a part of a picture. The bits depend only on the request and the pixel.
 * @example
 * import { DEFAULT_SETTINGS, makeObject, makeScene, perspective, plane, restingAt } from 'slowlight/scene';
 * const wall = makeObject({ path: '/Wall', mesh: plane(20, 20), motion: restingAt([0, 0, -4]) });
 * const scene = createTracedScene(makeScene({ name: 'wall', objects: [wall] }), 10);
 * const view = {
 *   t: 0,
 *   position: [0, 0, 0],
 *   u: [0, 0, -0.75],
 *   orientation: [0, 0, 0, 1],
 *   lens: perspective(0.01),
 * } as const;
 * const request: TileRequest = {
 *   view,
 *   settings: DEFAULT_SETTINGS,
 *   width: 1,
 *   height: 1,
 *   layers: ['depth', 'doppler'],
 *   samples: 1,
 *   seed: 1,
 *   light: DEFAULT_LIGHT,
 * };
 * // Seen from 0.6 c the wall is D = 2 times as far.
 * renderTile(scene, request, { x0: 0, y0: 0, x1: 1, y1: 1 }); // { depth: [8], doppler: [2] }
 */
export function renderTile(scene: TracedScene, request: TileRequest, tile: ImageTile): TileData {
  const data: TileData = {};
  const pixels = (tile.x1 - tile.x0) * (tile.y1 - tile.y0);
  for (const layer of request.layers) data[layer] = new Float32Array(pixels * channelsOf(layer));
  if (SAMPLED.some((layer) => data[layer])) fillBeauty(scene, request, tile, data);
  fillData(scene, request, tile, data);
  return data;
}

function fillData(scene: TracedScene, request: TileRequest, { x0, y0, x1, y1 }: ImageTile, data: TileData): void {
  const { view, settings, width, height, layers } = request;
  const named = layers.filter((layer): layer is DataAov => !(SAMPLED as readonly OutputLayer[]).includes(layer));
  if (named.length === 0) return;
  const readers = named.map((name) => ({ read: aovReader(name, scene, view.u, settings), out: data[name] }));
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++) {
      const ray = cameraRay(view, settings, x + 0.5, y + 0.5, width, height);
      const hit = ray && visibleHit(scene, ray);
      if (!hit) continue;
      const pixel = (y - y0) * (x1 - x0) + (x - x0);
      for (const { read, out } of readers) {
        const values = read(hit, ray);
        out?.set(values, pixel * values.length);
      }
    }
}
