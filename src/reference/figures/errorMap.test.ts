import { expect, test } from 'vitest';
import { magma } from '../../spectrum/falseColor/colorMaps.ts';
import { comparisonSheet, errorMap } from './errorMap.ts';
import { glyph } from './glyphs.ts';
import { createCanvas, drawText, textWidth } from './pixelCanvas.ts';

test('magma is that of matplotlib', () => {
  // Colours 0, 64, 128, 192 and 255 of matplotlib's table.
  const expected = ['#000004', '#51127c', '#b73779', '#fc8961', '#fcfdbf'];
  [0, 64, 128, 192, 255].forEach((i, n) => {
    const expectedRgb = [1, 3, 5].map((at) => Number.parseInt(expected[n].slice(at, at + 2), 16));
    magma(i / 255).forEach((value, k) => void expect(Math.abs(value - expectedRgb[k])).toBeLessThanOrEqual(1));
  });
  expect(magma(-1)).toEqual(magma(0));
  expect(magma(Number.POSITIVE_INFINITY)).toEqual(magma(1));
});

test('no error is black, `max` and all above are brightest, NaN is grey', () => {
  const { pixels } = errorMap([0, 2, Number.POSITIVE_INFINITY, Number.NaN], 2, 2, 2);
  const at = (i: number) => [...pixels.subarray(4 * i, 4 * i + 4)];
  expect(at(0)).toEqual([0, 0, 4, 255]);
  expect(at(1)).toEqual([252, 253, 191, 255]);
  expect(at(2)).toEqual(at(1));
  const [r, g, b] = at(3);
  expect(Math.max(r, g, b) - Math.min(r, g, b)).toBeLessThan(10);
});

test('draws the dots of a letter', () => {
  const on = createCanvas(5, 7, [0, 0, 0]);
  drawText(on, 'a', 0, 0, 1, [255, 255, 255]);
  const rows = Array.from({ length: 7 }, (_, y) =>
    Array.from({ length: 5 }, (_, x) => (on.pixels[4 * (5 * y + x)] ? '#' : '.')).join(''),
  );
  expect(rows).toEqual(['.###.', '#...#', '#...#', '#####', '#...#', '#...#', '#...#']);
});

test('every letter has its own shape', () => {
  const letters = [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:-+_/%()>'];
  expect(new Set(letters.map((letter) => glyph(letter).join())).size).toBe(letters.length);
  for (const letter of letters) expect(glyph(letter)).toHaveLength(7);
});

test('a sheet fits its pictures side by side and its legend', () => {
  for (const [width, columns] of [
    [4, 1],
    [4, 3],
    [200, 3],
    [960, 1],
  ]) {
    const picture = createCanvas(width, 30, [255, 0, 0]);
    const made = comparisonSheet(
      Array.from({ length: columns }, () => ({ picture, caption: 'A' })),
      { title: 'DISPLACEMENT (PIXELS)', max: 2 },
    );
    expect(made.width).toBeGreaterThanOrEqual(Math.max(width * columns, textWidth('DISPLACEMENT (PIXELS)', 1)));
    expect(made.height).toBeGreaterThan(50);
    const red = made.pixels.filter((value, i) => i % 4 === 0 && value === 255 && made.pixels[i + 1] === 0).length;
    expect(red).toBe(width * 30 * columns);
  }
});
