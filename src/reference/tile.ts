import { AOVS, type AovName, type RenderSettings, type ViewPoint } from '../scene/view.ts';
import { type DataAov, dataReader } from './aov.ts';
import { cameraRay } from './camera.ts';
import type { TracedScene } from './trace.ts';
import { visibleHit } from './visible.ts';

/** What a picture is to be. */
export interface TileRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** Of the whole picture [px]. */
  readonly width: number;
  readonly height: number;
  readonly aovs: readonly AovName[];
  /** n × n samples per pixel of the beauty. */
  readonly samples: number;
  readonly seed: number;
}

/** Pixels x0 ≤ x < x1, y0 ≤ y < y1, from the top left. */
export interface Tile {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

/** What was asked for: as many values per pixel as the AOV has channels, rows from the top. */
export type TileData = Partial<Record<AovName, Float32Array>>;

/** Draws a part of a picture. Its bits depend on nothing but the request and the pixel. */
export function renderTile(scene: TracedScene, request: TileRequest, tile: Tile): TileData {
  const data: TileData = {};
  const pixels = (tile.x1 - tile.x0) * (tile.y1 - tile.y0);
  for (const name of request.aovs) data[name] = new Float32Array(pixels * AOVS[name].channels.length);
  fillData(scene, request, tile, data);
  return data;
}

function fillData(scene: TracedScene, request: TileRequest, { x0, y0, x1, y1 }: Tile, data: TileData): void {
  const { view, settings, width, height, aovs } = request;
  const named = aovs.filter((name): name is DataAov => name !== 'beauty');
  if (named.length === 0) return;
  const readers = named.map((name) => ({ read: dataReader(name, scene, view.u, settings.view), out: data[name] }));
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++) {
      const ray = cameraRay(view, settings, x + 0.5, y + 0.5, width, height);
      const hit = visibleHit(scene, ray);
      if (!hit) continue;
      const pixel = (y - y0) * (x1 - x0) + (x - x0);
      for (const { read, out } of readers) {
        const values = read(hit, ray);
        out?.set(values, pixel * values.length);
      }
    }
}
