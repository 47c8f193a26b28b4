import type { Picture } from '../picture.ts';

/** The pictures of flip.py, by the same formulas: the one that is judged, then the one that it should be. */
export const WIDTH = 24;
export const HEIGHT = 18;

type Formula = (x: number, y: number, k: number) => number;

export const picture = (value: Formula, width = WIDTH, height = HEIGHT): Picture => ({
  width,
  height,
  rgb: Float32Array.from({ length: 3 * width * height }, (_, i) => {
    const pixel = Math.floor(i / 3);
    return value(pixel % width, Math.floor(pixel / width), i % 3);
  }),
});

const squares: Formula = (x, y, k) =>
  (Math.floor(x / 6) + Math.floor(y / 6)) % 2 === 0 ? [1, 0.5, 0][k] : [0.125, 0.25, 0.75][k];
const patch: Formula = (x, y, k) => (x >= 8 && x < 16 && y >= 5 && y < 13 ? [8, 4, 1][k] : 0);
const ramp: Formula = (x, y, k) => [x / 23, y / 17, 0.5][k];

const formulas: Readonly<Record<string, readonly [test: Formula, reference: Formula]>> = {
  noise: [
    (x, y, k) => ((x * x * 37 + y * 91 + k * 53) % 101) / 100,
    (x, y, k) => ((x * 29 + y * y * 83 + k * 47) % 101) / 100,
  ],
  darker: [ramp, (x, y, k) => 0.9 * ramp(x, y, k)],
  shifted: [(x, y, k) => squares(x + 1, y, k), squares],
  firefly: [(x, y) => (x === 12 && y === 9 ? 1 : 0.2), () => 0.2],
  bright: [(x, y, k) => 2 ** ((x - y) / 3 - k) * (x % 3 === 0 ? 1.25 : 1), (x, y, k) => 2 ** ((x - y) / 3 - k)],
  night: [(x, y, k) => patch(x - 2, y, k), patch],
};

export const pair = (name: string): readonly [test: Picture, reference: Picture] => [
  picture(formulas[name][0]),
  picture(formulas[name][1]),
];
