import { add, scale, type Vec3, ZERO } from '../math/vec3.ts';
import { isLuminous } from '../scene/views/views.ts';
import { toneMap, unlitShare } from '../spectrum/display/toneMap.ts';
import type { Hit, SpacetimeRay } from './acceleration/ray.ts';
import { dopplerOfHit } from './aov.ts';
import { cameraRay } from './camera/cameraRay.ts';
import { groundGrid, type Overlay } from './camera/groundGrid.ts';
import { visibleHit } from './camera/visibleHit.ts';
import { DisplayPixel } from './displayPixel.ts';
import type { TracedScene } from './intersection/tracedScene.ts';
import { materialOf } from './materials/material.ts';
import { surfaceAt } from './materials/surface.ts';
import { pixelSequence } from './sampling/pixelSequence.ts';
import { sensorsOf } from './spectral/sensors.ts';
import { starField } from './starField.ts';
import type { ImageTile, TileRequest } from './tileRequest.ts';
import { radiance } from './transport/path.ts';

/** Receive the means of a tile's samples, 3 values per pixel; absent where a layer is not requested. */
export interface BeautyBuffers {
  readonly beauty?: Float32Array;
  readonly picture?: Float32Array;
}

/**
 * Renders the `beauty` and `picture` layers of a tile: means over n × n samples per pixel; a single sample is at the pixel's centre, where
 * the data are taken. `picture` is the same as `DisplayPixel` shows it. Each pixel has a random sequence of its own, so the bits do not depend on the
 * division into tiles.
 */
export function fillBeauty(scene: TracedScene, request: TileRequest, tile: ImageTile, means: BeautyBuffers): void {
  const { x0, y0, x1, y1 } = tile;
  const { view, settings, width, height, samples: n, seed, light } = request;
  const overlays = overlaysOf(scene, request);
  const stars = starField(scene, request, tile);
  const createSensor = sensorsOf(settings, n * n);
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++) {
      const sampleSequence = pixelSequence(seed, x, y);
      let sum: Vec3 = ZERO;
      const display = new DisplayPixel(settings);
      for (let i = 0; i < n * n; i++) {
        const random = sampleSequence(i);
        const [right, down] = n === 1 ? [0.5, 0.5] : [random(), random()];
        const [px, py] = [x + right, y + down];
        const ray = cameraRay(view, settings, px, py, width, height);
        if (!ray) {
          if (means.picture) display.add(ZERO, undefined, []);
          continue;
        }
        const gathered = radiance(scene, ray, view, settings, light, random, createSensor(random));
        const arrived = stars ? add(gathered, stars(ray, px, py)) : gathered;
        sum = add(sum, arrived);
        // One sample has nothing to be averaged with.
        const object = n > 1 && means.picture ? visibleHit(scene, ray, 'hit')?.object : undefined;
        if (means.picture) display.add(arrived, object, overlays(ray, px, py));
      }
      const pixel = 3 * ((y - y0) * (x1 - x0) + (x - x0));
      means.beauty?.set(scale(sum, 1 / (n * n)), pixel);
      means.picture?.set(display.mean(), pixel);
    }
}

/** What is drawn over the light of a picture's point, along this ray: the colours of unlit surfaces, and the grid. */
function overlaysOf(
  scene: TracedScene,
  request: TileRequest,
): (ray: SpacetimeRay, x: number, y: number) => readonly Overlay[] {
  const { settings, view, width, height } = request;
  const hasUnlit = scene.scene.materials.some(({ unlit }) => unlit) && settings.tone !== 'linear';
  if (!settings.grid && !hasUnlit) return () => [];
  const grid = settings.grid ? groundGrid(scene, view, width, height) : undefined;
  return (ray, x, y) => {
    const hit = visibleHit(scene, ray);
    const share = hit && materialOf(scene, hit).unlit ? unlitShare(shiftOf(hit, ray, request)) : 0;
    // Its colour itself, which has no noise of sampled wavelengths.
    const own = hit && share > 0 ? toneMap(surfaceAt(scene, hit).emissive, settings.exposure, 'linear') : undefined;
    const drawn = grid?.(x, y, hit?.s ?? Number.POSITIVE_INFINITY);
    return [...(own ? [{ color: own, cover: share }] : []), ...(drawn ? [drawn] : [])];
  };
}

/** D, as far as colours or brightness follow it. */
function shiftOf(hit: Hit, ray: SpacetimeRay, { settings, view }: TileRequest): number {
  const { dopplerMix, beaming } = settings;
  return isLuminous(settings) ? dopplerOfHit(hit, ray, view.u) ** Math.max(dopplerMix, beaming) : 1;
}
