import { random } from '../../src/math/random.ts';
import type { RasterRenderer } from '../../src/render/api.ts';
import type { RenderSettings, ViewPoint } from '../../src/scene/view/view.ts';
import type { PixelSample } from './pixelOracle.ts';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A picture to make, and the pixels of it that are wanted. Plain data: it travels to a page. */
export interface PixelRequest extends Size {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** Places in the picture's rows; absent: all. */
  readonly pixels?: readonly number[];
}

/** What is read of every pixel, one after the other, in this order. */
const NAMES = ['object', 'position', 'emission_time', 'depth', 'doppler', 'velocity', 'albedo'] as const;
const FLOATS = 13;

/** Makes the picture; `FLOATS` numbers for each wanted pixel. */
export async function readSamplePixels(renderer: RasterRenderer, order: PixelRequest): Promise<Float32Array> {
  const { view, settings, width, height } = order;
  if (renderer.width !== width || renderer.height !== height) renderer.setSize(width, height);
  renderer.render([view], settings);
  const aovs: Float32Array[] = [];
  for (const name of NAMES) aovs.push(await renderer.readAov(name));
  const pixels = order.pixels ?? allPixels(order);
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

/** Different pixels of a picture, drawn evenly. */
export function somePixels({ width, height }: Size, count: number, seed: number): readonly number[] {
  const next = random(seed);
  const chosen = new Set<number>();
  while (chosen.size < count) chosen.add(Math.floor(next() * width * height));
  return [...chosen];
}

/** What the pixel at place `k` of `readSamplePixels` says. */
export function pixelSampleAt(values: Float32Array, k: number): PixelSample {
  const [object, x, y, z, time, depth, doppler, vx, vy, vz, r, g, b] = values.subarray(FLOATS * k, FLOATS * (k + 1));
  return { object, position: [x, y, z], time, depth, doppler, velocity: [vx, vy, vz], albedo: [r, g, b] };
}
