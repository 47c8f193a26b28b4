import { describe, expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import { convolve, emptyChannel, type FeatureMap, maxPool, upsample } from './convolution.ts';
import { denoiseTile } from './denoiseTile.ts';
import type { NoisyTile } from './noisyTile.ts';
import { decodeLight, encodeLight } from './transfer.ts';

const next = random(5);

function noiseMap(width: number, height: number, count: number): FeatureMap {
  const channels = Array.from({ length: count }, () => {
    const channel = emptyChannel(width, height);
    for (let y = 1; y <= height; y++) for (let x = 1; x <= width; x++) channel[y * (width + 2) + x] = next() - 0.5;
    return channel;
  });
  return { width, height, channels };
}

/** A value inside the map. */
const at = ({ width, channels }: FeatureMap, k: number, x: number, y: number): number =>
  channels[k]![(y + 1) * (width + 2) + x + 1]!;

describe('layers', () => {
  it('convolve by the definition: sums over channels and 3 × 3 neighbours, zero outside', () => {
    const [width, height, inputs, outputs] = [5, 4, 3, 6];
    const map = noiseMap(width, height, inputs);
    const values = Float32Array.from({ length: outputs * inputs * 9 }, () => next() - 0.5);
    const bias = Float32Array.from({ length: outputs }, () => next() - 0.5);
    const layer = { weight: { dims: [outputs, inputs, 3, 3], values }, bias: { dims: [outputs], values: bias } };
    const found = convolve(map, layer);
    for (let o = 0; o < outputs; o++)
      for (let y = 0; y < height; y++)
        for (let x = 0; x < width; x++) {
          let sum = bias[o]!;
          for (let i = 0; i < inputs; i++)
            for (let j = 0; j < 9; j++) {
              const [u, v] = [x + (j % 3) - 1, y + Math.floor(j / 3) - 1];
              if (u >= 0 && v >= 0 && u < width && v < height)
                sum += values[(o * inputs + i) * 9 + j]! * at(map, i, u, v);
            }
          expect(at(found, o, x, y)).toBeCloseTo(Math.max(sum, 0), 6);
        }
  });

  it('halve and double the resolution', () => {
    const map = noiseMap(6, 4, 2);
    const half = maxPool(map);
    expect([half.width, half.height]).toEqual([3, 2]);
    expect(at(half, 1, 2, 1)).toBe(Math.max(...[4, 5].flatMap((x) => [2, 3].map((y) => at(map, 1, x, y)))));
    const twice = upsample(half);
    for (const [x, y] of [
      [0, 0],
      [5, 3],
      [2, 1],
    ] as const)
      expect(at(twice, 0, x, y)).toBe(at(half, 0, x >> 1, y >> 1));
  });
});

it('light is encoded increasingly to 0 … 1, and back', () => {
  expect(encodeLight(0)).toBe(0);
  expect(encodeLight(65504)).toBe(1);
  const lights = Array.from({ length: 60 }, (_, k) => 2 ** (k / 2 - 20));
  for (const [k, light] of lights.entries()) {
    expect(Math.abs(decodeLight(encodeLight(light)) / light - 1)).toBeLessThan(1e-3);
    if (k > 0) expect(encodeLight(light)).toBeGreaterThan(encodeLight(lights[k - 1]!));
  }
});

describe('the denoiser', () => {
  const [width, height] = [40, 24];
  const window = { x0: 0, y0: 0, x1: width, y1: height };
  /** Two flat walls of other colours and normals, with noise of the relative size `noise`. */
  function walls(noise: number, gain = 1): NoisyTile {
    const random01 = random(3);
    const values = new Float32Array(9 * width * height);
    for (let i = 0; i < width * height; i++) {
      const left = i % width < width / 2;
      const light = (1 + noise * (2 * random01() - 1)) / gain;
      const beauty = (left ? [0.4, 0.2, 0.1] : [0.1, 0.2, 0.4]).map((c) => c * light);
      const guides = left ? [0.8, 0.4, 0.2, 1, 0, 0] : [0.2, 0.4, 0.8, 0, 0, 1];
      values.set([...beauty, ...guides], 9 * i);
    }
    return { window, values, gain };
  }
  const lightOf = ({ values }: NoisyTile): Float32Array =>
    Float32Array.from({ length: values.length / 3 }, (_, i) => values[9 * Math.floor(i / 3) + (i % 3)]!);
  const errorOf = (values: Float32Array, exact: Float32Array): number =>
    Math.sqrt(values.reduce((sum, value, i) => sum + (value - exact[i]!) ** 2, 0) / values.length);

  it('removes four fifths of the noise of flat walls, and keeps their edge', () => {
    const exact = lightOf(walls(0));
    const noisy = walls(0.9);
    const clean = denoiseTile(window, noisy);
    expect(errorOf(clean, exact)).toBeLessThan(0.2 * errorOf(lightOf(noisy), exact));
    const redAt = (x: number): number => clean[3 * (12 * width + x)]!;
    expect(redAt(width / 2 - 1)).toBeGreaterThan(0.3);
    expect(redAt(width / 2)).toBeLessThan(0.2);
  });

  it('leaves what has no noise nearly as it is, at any exposure', () => {
    for (const gain of [1, 64]) {
      const beauty = lightOf(walls(0, gain));
      const clean = denoiseTile(window, walls(0, gain));
      expect(errorOf(clean, beauty)).toBeLessThan(0.02 * Math.max(...beauty));
    }
  });

  it('gives the part of its window that is the tile', () => {
    const whole = denoiseTile(window, walls(0.5));
    const tile = { x0: 8, y0: 3, x1: 21, y1: 9 };
    const part = denoiseTile(tile, walls(0.5));
    for (let y = tile.y0; y < tile.y1; y++) {
      const row = part.subarray(3 * 13 * (y - tile.y0), 3 * 13 * (y - tile.y0 + 1));
      expect(row).toEqual(whole.subarray(3 * (y * width + tile.x0), 3 * (y * width + tile.x1)));
    }
  });
});
