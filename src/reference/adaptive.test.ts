import { describe, expect, it } from 'vitest';
import { area, DIRECT, dome, GREY, lambert, lit } from '../../tests/support/lightKit.ts';
import { viewFrom } from '../../tests/support/rays.ts';
import { fromAxisAngle } from '../math/quat.ts';
import { plane } from '../scene/mesh/primitives.ts';
import { lookAtOrientation } from '../scene/view/camera.ts';
import { perspective } from '../scene/view/lenses/perspectiveLens.ts';
import { renderTile } from './tile.ts';
import type { ImageTile, TileData, TileRequest } from './tileRequest.ts';

/** Side [m]. */
const LAMP = 2;
/** Of the edge of the wall against the sides of the lamp, so that no stratum of the lamp is hidden as a whole [rad]. */
const EDGE = 0.6;
const wall = {
  kind: 'static',
  pose: { position: [20 * Math.cos(EDGE), 20 * Math.sin(EDGE), 2], orientation: fromAxisAngle([0, 0, 1], EDGE) },
} as const;
/** A black wall that hides half of a lamp from part of a white floor: a soft shadow, and deep under the wall no noise. */
const shadow = lit(
  [
    { mesh: plane(40, 40), material: lambert(1) },
    { mesh: { ...plane(40, 40), doubleSided: true }, material: lambert(0), motion: wall },
  ],
  [area('rect', [0, 0, 4], { width: LAMP, height: LAMP })],
);

const [width, height] = [24, 14];
const WHOLE: ImageTile = { x0: 0, y0: 0, x1: width, y1: height };
const request: TileRequest = {
  // Under the wall, looking down and to both sides.
  view: {
    ...viewFrom({ position: [0, 0, 1.9] }),
    orientation: lookAtOrientation([0, 0, -1], [0, 1, 0]),
    lens: perspective(1.6),
  },
  settings: GREY,
  width,
  height,
  layers: ['beauty', 'picture', 'sample_count'],
  samples: 8,
  seed: 3,
  light: DIRECT,
};
const adaptive = { noiseThreshold: 0.04, minSamples: 3 };

const draw = (more: Partial<TileRequest>, tile = WHOLE, scene = shadow): TileData =>
  renderTile(scene, { ...request, ...more }, tile);

describe('adaptive sampling', () => {
  const counts = draw({ adaptive }).sample_count!;

  it('takes samples where the noise is, and between the least and the most', () => {
    expect(Math.min(...counts)).toBe(12);
    expect(Math.max(...counts)).toBe(64);
    expect(new Set(counts).size).toBeGreaterThan(2);
    for (const minSamples of [1, 5, 8, 12]) {
      const found = draw({ adaptive: { ...adaptive, minSamples } }).sample_count!;
      expect(Math.min(...found)).toBeGreaterThanOrEqual(Math.min(minSamples ** 2, 64));
      expect(Math.max(...found)).toBeLessThanOrEqual(64);
    }
  });

  it('off, or with a threshold of 0, is n × n samples everywhere: the same bits', () => {
    const plain = draw({});
    expect(draw({ adaptive: { ...adaptive, noiseThreshold: 0 } })).toEqual(plain);
    expect(new Set(plain.sample_count)).toEqual(new Set([64]));
  });

  it('ends at once where there is no noise', () => {
    const white = lit([], [dome([0.5, 0.5, 0.5])]);
    expect(new Set(draw({ adaptive }, WHOLE, white).sample_count)).toEqual(new Set([12]));
  });

  it.each(['beauty', 'picture'] as const)('judges what is requested: %s', (layer) => {
    const only = draw({ adaptive, layers: [layer, 'sample_count'] });
    expect(Math.min(...only.sample_count!)).toBeLessThan(64);
    expect(only[layer]!.length).toBe(3 * width * height);
  });

  it('has the same bits however the picture is divided into tiles', () => {
    const whole = draw({ adaptive });
    const cuts: ImageTile[] = [
      { x0: 0, y0: 0, x1: 9, y1: 5 },
      { x0: 9, y0: 0, x1: width, y1: 5 },
      { x0: 0, y0: 5, x1: width, y1: height },
    ];
    for (const tile of cuts)
      for (const [name, values] of Object.entries(draw({ adaptive }, tile))) {
        const channels = name === 'sample_count' ? 1 : 3;
        const row = channels * (tile.x1 - tile.x0);
        for (let y = tile.y0; y < tile.y1; y++) {
          const from = channels * (y * width + tile.x0);
          const expected = whole[name as 'beauty']!.slice(from, from + row);
          expect(values.slice((y - tile.y0) * row, (y - tile.y0 + 1) * row), `${name} ${y}`).toEqual(expected);
        }
      }
  });

  it('has the mean of the closed form: a point from which half of the lamp is hidden', () => {
    const spot = { ...request.view, position: [0, 0, 1], lens: perspective(1e-4) } as const;
    // E/L = 2 πF of a square of 1 × 1 at the height 4 with a corner above the point. Source: Howell, Catalog of radiation heat transfer, B-3.
    const [side, h] = [LAMP / 2, 4];
    const expected = ((2 / Math.PI) * side * Math.atan(side / Math.hypot(side, h))) / Math.hypot(side, h);
    const few = { noiseThreshold: 0.08, minSamples: 2 };
    const pictures = Array.from({ length: 200 }, (_, seed) =>
      draw({ view: spot, width: 4, height: 4, seed, adaptive: few, layers: ['beauty', 'sample_count'] }, SPOT),
    );
    const ends = pictures.map(({ sample_count }) => sample_count![0]);
    expect(new Set(ends).size).toBeGreaterThan(1);
    const means = pictures.map(({ beauty }) => mean(beauty!));
    const error = Math.sqrt(mean(means.map((x) => (x - expected) ** 2)) / means.length);
    expect(error).toBeLessThan(0.003 * expected);
    expect(Math.abs(mean(means) - expected)).toBeLessThan(3 * error);
  });
});

const SPOT: ImageTile = { x0: 0, y0: 0, x1: 4, y1: 4 };
const mean = (values: ArrayLike<number>): number => Array.from(values).reduce((a, b) => a + b) / values.length;
