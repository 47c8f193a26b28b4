import { add, scale, type Vec3, ZERO } from '../math/vec3.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import { isLuminous } from '../scene/views/views.ts';
import { encodeSrgb } from '../spectrum/display/srgb.ts';
import { toneMap, unlitShare } from '../spectrum/display/toneMap.ts';
import type { Hit, SpacetimeRay } from './acceleration/ray.ts';
import { dopplerOfHit } from './aov.ts';
import { cameraRay } from './camera/cameraRay.ts';
import { groundGrid, type Overlay } from './camera/groundGrid.ts';
import { visibleHit } from './camera/visibleHit.ts';
import { DisplayPixel, meanWithoutFireflies } from './displayPixel.ts';
import type { TracedScene } from './intersection/tracedScene.ts';
import { materialOf } from './materials/material.ts';
import { surfaceAt } from './materials/surface.ts';
import { noiseLimit, sampleCounts, varianceOfMean } from './sampling/adaptiveSampling.ts';
import { pixelSequence } from './sampling/pixelSequence.ts';
import { sensorsOf } from './spectral/sensors.ts';
import { squaresOf } from './squares.ts';
import { starField } from './starField.ts';
import type { ImageTile, TileRequest } from './tileRequest.ts';
import { radiance } from './transport/path.ts';

/** Receive the means of a tile's samples, and their number; absent where a layer is not requested. */
export interface BeautyBuffers {
  readonly beauty?: Float32Array;
  readonly picture?: Float32Array;
  readonly denoiser_input?: Float32Array;
  readonly sample_count?: Float32Array;
}

/**
 * Side of the blocks of adaptive sampling [px]. A single pixel's estimate of its error is so uncertain that many would end by chance before they have met
 * what is bright and rare, and be too dark; a block's is not.
 */
const BLOCK = 4;

/**
 * Renders the `beauty` and `picture` layers of a tile: means over n × n samples per pixel, or fewer with adaptive sampling; a single sample is at the
 * pixel's centre, where the data are taken. `picture` is the same as `DisplayPixel` shows it. Each pixel has a random sequence of its own, and the
 * blocks that end together are those of the picture, so the bits do not depend on the division into tiles.
 */
export function fillBeauty(scene: TracedScene, request: TileRequest, tile: ImageTile, means: BeautyBuffers): void {
  const { settings, adaptive, samples: n, width, height } = request;
  const counts = adaptive ? sampleCounts(adaptive, n) : [n * n];
  const side = adaptive ? BLOCK : 1;
  const sampled = wholeBlocks(tile, side, width, height);
  const sampler = pixelSampler(scene, request, sampled, means);
  for (const block of squaresOf(sampled, side)) {
    const pixels = squaresOf(block, 1).map(({ x0: x, y0: y }) => ({ x, y, take: sampler(x, y), samples: noSamples() }));
    for (const count of counts) {
      for (const { samples, take } of pixels) while (samples.length < count) samples.push(take(samples.length));
      if (adaptive && count < n * n && noiseOf(pixels, settings, means) < noiseLimit(adaptive, count, n)) break;
    }
    for (const { x, y, samples } of pixels) {
      if (x < tile.x0 || x >= tile.x1 || y < tile.y0 || y >= tile.y1) continue;
      const pixel = (y - tile.y0) * (tile.x1 - tile.x0) + (x - tile.x0);
      means.beauty?.set(meanLight(samples), 3 * pixel);
      means.picture?.set(displayed(samples, settings), 3 * pixel);
      means.denoiser_input?.set(denoiserInput(samples, settings, means.picture !== undefined), 9 * pixel);
      means.sample_count?.fill(samples.length, pixel, pixel + 1);
    }
  }
}

/** The blocks of the picture that a tile touches, as one tile. */
function wholeBlocks({ x0, y0, x1, y1 }: ImageTile, side: number, width: number, height: number): ImageTile {
  const end = (pixel: number, size: number): number => Math.min(Math.ceil(pixel / side) * side, size);
  return { x0: x0 - (x0 % side), y0: y0 - (y0 % side), x1: end(x1, width), y1: end(y1, height) };
}

/** A sample of a pixel: its light, what its ray meets (undefined: the sky), what is drawn over it, and its surface for the denoiser. */
interface PixelSample {
  readonly light: Vec3;
  readonly object: number | undefined;
  readonly overlays: readonly Overlay[];
  readonly albedo: Vec3;
  readonly normal: Vec3;
}

const NOTHING: PixelSample = { light: ZERO, object: undefined, overlays: [], albedo: ZERO, normal: ZERO };
const noSamples = (): PixelSample[] => [];

/** Returns what takes sample i of a pixel, with what the requested layers need. */
function pixelSampler(
  scene: TracedScene,
  request: TileRequest,
  tile: ImageTile,
  { picture, denoiser_input: guided }: BeautyBuffers,
): (x: number, y: number) => (i: number) => PixelSample {
  const { view, settings, width, height, samples: n, seed, light } = request;
  const overlays = overlaysOf(scene, request);
  const stars = starField(scene, request, tile);
  const createSensor = sensorsOf(settings, n * n);
  return (x, y) => {
    const sampleSequence = pixelSequence(seed, x, y);
    return (i) => {
      const random = sampleSequence(i);
      const [right, down] = n === 1 ? [0.5, 0.5] : [random(), random()];
      const [px, py] = [x + right, y + down];
      const ray = cameraRay(view, settings, px, py, width, height);
      if (!ray) return NOTHING;
      const gathered = radiance(scene, ray, view, settings, light, random, createSensor(random));
      const arrived = stars ? add(gathered, stars(ray, px, py)) : gathered;
      const hit = guided && visibleHit(scene, ray);
      const { albedo, normal } = hit ? surfaceAt(scene, hit) : NOTHING;
      if (!picture) return { ...NOTHING, light: arrived, albedo, normal };
      // One sample has nothing to be averaged with.
      const object = n > 1 ? visibleHit(scene, ray, 'hit')?.object : undefined;
      return { light: arrived, object, overlays: overlays(ray, px, py), albedo, normal };
    };
  };
}

function mean(samples: readonly PixelSample[], of: 'light' | 'albedo' | 'normal'): Vec3 {
  let sum: Vec3 = ZERO;
  for (const sample of samples) sum = add(sum, sample[of]);
  return scale(sum, 1 / samples.length);
}

const meanLight = (samples: readonly PixelSample[]): Vec3 => mean(samples, 'light');

function denoiserInput(samples: readonly PixelSample[], settings: RenderSettings, isDisplayed: boolean): number[] {
  const lights = samples.map(({ light }) => light);
  const light = isDisplayed ? meanWithoutFireflies(lights, settings) : meanLight(samples);
  return [...light, ...mean(samples, 'albedo'), ...mean(samples, 'normal')];
}

/** Linear sRGB to display. */
function displayed(samples: readonly PixelSample[], settings: RenderSettings): Vec3 {
  const display = new DisplayPixel(settings);
  for (const { light, object, overlays } of samples) display.add(light, object, overlays);
  return display.mean();
}

/** The noise of a block's pixels, as `AdaptiveSampling` defines it: that of the beauty unless only the picture is requested, and of both the greater. */
function noiseOf(
  pixels: readonly { readonly samples: readonly PixelSample[] }[],
  settings: RenderSettings,
  means: BeautyBuffers,
): number {
  const rms = (measure: (samples: readonly PixelSample[]) => Vec3): number => {
    const variances = pixels.map(({ samples }) =>
      varianceOfMean(samples.length, (from, to) => measure(samples.slice(from, to))),
    );
    return Math.sqrt(meanOf(variances));
  };
  const shown = means.picture ? rms((samples) => displayed(samples, settings).map(encodeSrgb) as unknown as Vec3) : 0;
  if (means.picture && !means.beauty) return shown;
  const error = rms(meanLight);
  return error > 0 ? Math.max(shown, error / meanOf(pixels.map(({ samples }) => meanLight(samples)))) : shown;
}

const meanOf = (values: readonly Vec3[]): number =>
  values.reduce((sum, [r, g, b]) => sum + r + g + b, 0) / (3 * values.length);

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
