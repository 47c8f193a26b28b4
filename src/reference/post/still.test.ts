import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { makeStillPixels } from '../../scene/frameGraph/still.ts';
import { stillImage } from './still.ts';

const still = (width: number, height: number, value: (x: number, y: number, k: number) => number) =>
  makeStillPixels(
    width,
    height,
    Float32Array.from({ length: 3 * width * height }, (_, i) => {
      const pixel = Math.floor(i / 3);
      return value(pixel % width, Math.floor(pixel / width), i % 3);
    }),
  );
const noise = (x: number, y: number, k: number): number =>
  (1e4 * (1 + Math.sin(12.9898 * x + 78.233 * y + 37 * k))) % 1;
const side = fc.integer({ min: 1, max: 40 });

describe('a still in a picture', () => {
  it('of the same size is itself', () => {
    fc.assert(
      fc.property(side, side, (width, height) => {
        const made = still(width, height, noise);
        expect(Float32Array.from(stillImage(made, width, height).values)).toEqual(made.pixels);
      }),
    );
  });

  it('fills the height of the picture, centred, with black beside it', () => {
    fc.assert(
      fc.property(side, side, side, side, (w, h, width, height) => {
        const shown = stillImage(
          still(w, h, () => 1),
          width,
          height,
        );
        // Half the still's width in pixels of the picture, and the distance of a pixel's centre from the middle.
        const half = (w * height) / h / 2;
        for (let x = 0; x < width; x++) {
          const distance = Math.abs(x + 0.5 - width / 2);
          if (Math.abs(distance - half) < 1e-9) continue;
          for (const y of [0, height - 1]) expect(shown.at(x, y)[0]).toBeCloseTo(distance < half ? 1 : 0, 12);
        }
      }),
    );
  });

  it('preserves a linear gradient, enlarged or reduced', () => {
    fc.assert(
      fc.property(fc.integer({ min: 8, max: 40 }), fc.integer({ min: 8, max: 40 }), (h, height) => {
        const made = still(h, h, (x, y, k) => [x, y, x + y][k]! / h);
        const shown = stillImage(made, height, height);
        const margin = Math.ceil(Math.max(1, height / h)) + 1;
        for (let i = margin; i < height - margin; i++) {
          const place = ((i + 0.5) / height) * h - 0.5;
          expect(shown.at(i, i)[0]).toBeCloseTo(place / h, 1);
          expect(shown.at(i, i)[2]).toBeCloseTo((2 * place) / h, 1);
        }
      }),
    );
  });

  it('conserves light when reduced, and uses every pixel', () => {
    const weightOf = (x: number, y: number): number => {
      const made = still(100, 64, (i, j) => (i === x && j === y ? 1 : 0));
      return (16 * stillImage(made, 25, 16).values.reduce((all, value) => all + value, 0)) / 3;
    };
    for (const [x, y] of [
      [50, 31],
      [13, 50],
      [84, 9],
    ] as const)
      expect(weightOf(x, y)).toBeCloseTo(1, 12);
    expect(weightOf(0, 0)).toBeGreaterThan(0.25);
  });
});

it('keys differ if sizes or pixels differ', () => {
  const keys = [
    still(4, 2, noise),
    still(2, 4, noise),
    still(4, 2, (x, y, k) => noise(x, y, k) + (x === 3 && y === 1 && k === 2 ? 1e-6 : 0)),
    still(4, 2, () => 0),
    still(4, 3, () => 0),
  ].map(({ key }) => key);
  expect(new Set(keys).size).toBe(5);
  expect(still(4, 2, noise).key).toBe(keys[0]);
});
