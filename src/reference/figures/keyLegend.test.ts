import { expect, it } from 'vitest';
import { keyLegendHeight, type SignRow, withKeyLegend } from './keyLegend.ts';
import { createCanvas, type PixelCanvas } from './pixelCanvas.ts';

const RED = [255, 0, 0] as const;
const row = (style: SignRow['style']): SignRow => ({ text: 'A = ∞', color: RED, style });
const isRed = ({ pixels, width }: PixelCanvas, x: number, y: number): boolean =>
  RED.every((value, k) => pixels[4 * (y * width + x) + k] === value);

it('a picture with a legend of signs below is of even height, and as it was', () => {
  for (const width of [40, 200, 1280])
    for (const count of [0, 1, 2, 3]) {
      const rows = Array.from({ length: count }, () => row('line'));
      const picture = createCanvas(width, 20, [0, 0, 255]);
      const whole = withKeyLegend(picture, rows);
      expect(whole.height).toBe(20 + keyLegendHeight(width, rows));
      expect(keyLegendHeight(width, rows) % 2).toBe(0);
      expect(whole.pixels.subarray(0, picture.pixels.length)).toEqual(picture.pixels);
      expect(count === 0).toBe(whole === picture);
    }
});

it('signs are a line, or hatching that falls or rises to the right', () => {
  const shown = (style: SignRow['style']) => withKeyLegend(createCanvas(200, 2, [0, 0, 0]), [row(style)]);
  const places = (canvas: PixelCanvas): readonly (readonly [number, number])[] =>
    Array.from({ length: canvas.height * canvas.width }, (_, i) => [i % 200, Math.floor(i / 200)] as const).filter(
      ([x, y]) => isRed(canvas, x, y),
    );
  expect(new Set(places(shown('line')).map(([, y]) => y)).size).toBe(1);
  for (const [style, down] of [
    ['falling', 1],
    ['rising', -1],
  ] as const) {
    const canvas = shown(style);
    const red = places(canvas);
    const rows = red.map(([, y]) => y);
    const inside = red.filter(([x, y]) => x > 6 && x < 14 && y > Math.min(...rows) && y < Math.max(...rows));
    expect(inside.length).toBeGreaterThan(10);
    // The next dot to the right, up or down, is of the same stroke.
    for (const [x, y] of inside) expect(isRed(canvas, x + 1, y + down)).toBe(true);
  }
});
