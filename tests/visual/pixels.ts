import { random } from '../../src/math/random.ts';
import type { RasterRenderer } from '../../src/render/api.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view/view.ts';
import type { PixelSample } from './pixelOracle.ts';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A picture to render, and the requested pixels. Plain data, to be sent to a page. */
export interface PixelRequest extends Size {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** Pixel indices, row by row; default: all. */
  readonly pixels?: readonly number[];
}

/** The values read per pixel, in this order. */
const NAMES = ['object', 'position', 'emission_time', 'depth', 'doppler', 'velocity', 'albedo'] as const;
const FLOATS = 13;

/** Renders the picture; returns `FLOATS` numbers per requested pixel. */
export async function readSamplePixels(renderer: RasterRenderer, request: PixelRequest): Promise<Float32Array> {
  const { view, settings, width, height } = request;
  if (renderer.width !== width || renderer.height !== height) renderer.setSize(width, height);
  renderer.render([view], settings);
  const aovs: Float32Array[] = [];
  for (const name of NAMES) aovs.push(await renderer.readAov(name));
  const pixels = request.pixels ?? allPixels(request);
  const out = new Float32Array(FLOATS * pixels.length);
  pixels.forEach((pixel, k) => {
    let at = FLOATS * k;
    for (const aov of aovs) {
      const channels = aov.length / (width * height);
      for (let n = 0; n < channels; n++) out[at++] = aov[channels * pixel + n];
    }
  });
  return out;
}

export const allPixels = ({ width, height }: Size): readonly number[] =>
  Array.from({ length: width * height }, (_, i) => i);

/** Distinct pixels of a picture, chosen uniformly. */
export function somePixels({ width, height }: Size, count: number, seed: number): readonly number[] {
  const next = random(seed);
  const chosen = new Set<number>();
  while (chosen.size < count) chosen.add(Math.floor(next() * width * height));
  return [...chosen];
}

/** The values of pixel `k` of `readSamplePixels`. */
export function pixelSampleAt(values: Float32Array, k: number): PixelSample {
  const [object, x, y, z, time, depth, doppler, vx, vy, vz, r, g, b] = values.subarray(FLOATS * k, FLOATS * (k + 1));
  return { object, position: [x, y, z], time, depth, doppler, velocity: [vx, vy, vz], albedo: [r, g, b] };
}
