import { describe, expect, it } from 'vitest';
import { toHalf } from '../../../math/half.ts';
import type { RadianceTexture } from '../../../scene/types.ts';
import { type Panorama, PREFILTER_SIZE, pixelOffset, prefilterDome, SPECULAR_LOBES } from './prefilteredDome.ts';

const [W, H] = [256, 128];

/** A dome of grey radiance by (row, column). */
const dome = (radiance: (y: number, x: number) => number): RadianceTexture => ({
  name: 'dome',
  width: W,
  height: H,
  data: Uint16Array.from({ length: 4 * W * H }, (_, i) => {
    const pixel = i >> 2;
    return toHalf(i % 4 === 3 ? 1 : radiance(Math.floor(pixel / W), pixel % W));
  }),
  colorSpace: 'linear',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'clamp',
});

const at = ({ width, rgb }: Panorama, y: number, x: number): number => rgb[3 * (y * width + x)];
const angle = (y: number): number => (Math.PI * (y + 0.5)) / PREFILTER_SIZE.height;

describe('a prefiltered dome', () => {
  it('is the dome itself if that is uniform, whatever its size', () => {
    for (const { rgb } of prefilterDome(dome(() => 3))) for (const x of rgb) expect(x).toBeCloseTo(3, 4);
    const one = {
      ...dome(() => 0),
      width: 1,
      height: 1,
      data: Uint8Array.of(255, 0, 0, 255),
      colorSpace: 'srgb',
    } as const;
    for (const { rgb } of prefilterDome(one))
      expect([...rgb.subarray(0, 3)]).toEqual([1, 0, 0].map((x) => expect.closeTo(x, 5)));
  });

  it('has the irradiance π (1 + cos θ)/2 for a uniform sky over dark ground', () => {
    const diffuse = prefilterDome(dome((y) => (y < H / 2 ? 1 : 0))).at(-1)!;
    for (let y = 0; y < PREFILTER_SIZE.height; y += 5)
      expect(Math.abs(at(diffuse, y, 17) - (1 + Math.cos(angle(y))) / 2)).toBeLessThan(0.01);
  });

  it('has one value at a pole, whatever the column', () => {
    const diffuse = prefilterDome(dome((y, x) => (y === 30 && x === 60 ? 1000 : 0))).at(-1)!;
    const pole = (column: number): number =>
      (diffuse.rgb[pixelOffset(diffuse, -1, column)] + diffuse.rgb[pixelOffset(diffuse, 0, column)]) / 2;
    for (let column = 0; column < PREFILTER_SIZE.width; column += 9) expect(pole(column) / pole(0)).toBeCloseTo(1, 2);
  });

  it('is the GGX lobe of the roughness, by half of the angle, for one bright point', () => {
    const maps = prefilterDome(dome((y, x) => (y === 64 && x === 128 ? 1000 : 0)));
    const lobe = (roughness: number, theta: number): number => {
      const spread = Math.cos(theta / 2) ** 2 * (roughness ** 4 - 1) + 1;
      return Math.cos(theta) / (spread * spread);
    };
    // On both sides of the point on the equator: in coarser maps it is up to half a texel beside its place.
    const value = (map: Panorama, column: number): number => at(map, 32, 64 + column) + at(map, 32, 64 - column);
    for (const k of [1, 2, 3]) {
      const theta = (column: number): number => (2 * Math.PI * column) / PREFILTER_SIZE.width;
      const expected = lobe(SPECULAR_LOBES[k].roughness, theta(24)) / lobe(SPECULAR_LOBES[k].roughness, theta(10));
      expect(Math.abs(value(maps[k], 24) / value(maps[k], 10) / expected - 1)).toBeLessThan(0.1);
    }
    // Light is neither lost nor made, but for what goes below the horizon.
    const total = (map: Panorama): number =>
      Array.from({ length: PREFILTER_SIZE.height }, (_, y) =>
        Array.from({ length: PREFILTER_SIZE.width }, (_, x) => at(map, y, x) * Math.sin(angle(y))).reduce(
          (a, b) => a + b,
        ),
      ).reduce((a, b) => a + b);
    for (const map of maps) expect(total(map) / (1000 / 4)).toBeCloseTo(1, 1);
  });
});
