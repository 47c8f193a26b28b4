import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../math/quat.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { domeLens } from '../../../scene/view/lenses/fisheyeLens.ts';
import type { Lens } from '../../../scene/view/lenses/lenses.ts';
import { perspective } from '../../../scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../../scene/view/view.ts';
import { applyEffect } from './applyEffect.ts';
import { FloatImage } from './effectInput.ts';

/** A black picture with a grid; of an observer in motion, of which a picture's own angles know nothing. */
const gridOf = (lens: Lens, args: readonly number[], width: number, height: number): FloatImage =>
  applyEffect('lens-grid', args, {
    image: new FloatImage(width, height),
    aovs: new Map(),
    view: { t: 0, position: [0, 0, 0], u: properVelocity([0, 0, -0.8]), orientation: IDENTITY, lens },
    settings: DEFAULT_SETTINGS,
    zenith: [0, 1, 0],
  });

const LINES = [15, 0, 1, 1] as const;

/** Middles and widths of the lines that a row or a column of pixels crosses [px], by the blue that they share. */
function linesAlong(values: readonly number[]): readonly { readonly at: number; readonly width: number }[] {
  const found: { at: number; width: number }[] = [];
  let sum = 0;
  let moment = 0;
  for (const [i, value] of [...values, 0].entries()) {
    sum += value;
    moment += value * (i + 0.5);
    if (value > 0 || sum === 0) continue;
    found.push({ at: moment / sum, width: sum });
    sum = 0;
    moment = 0;
  }
  return found;
}
const row = (image: FloatImage, y: number) => Array.from({ length: image.width }, (_, x) => image.at(x, y)[2]!);
const column = (image: FloatImage, x: number) => Array.from({ length: image.height }, (_, y) => image.at(x, y)[2]!);

describe('a test grid', () => {
  it('of an equirectangular picture is even: a line every 15°, twice as wide ahead and at the horizon', () => {
    const image = gridOf({ kind: 'equirectangular' }, LINES, 480, 240);
    // Between two lines of equal height, and between two of equal bearing.
    const across = linesAlong(row(image, 115));
    expect(across.slice(1, -1).map(({ at }) => Math.round(at))).toEqual(
      Array.from({ length: 23 }, (_, i) => 20 * (i + 1)),
    );
    for (const { at, width } of across.slice(1, -1)) expect(width).toBeCloseTo(Math.round(at) === 240 ? 2 : 1, 6);
    const down = linesAlong(column(image, 230)).filter(({ at }) => at > 10 && at < 230);
    expect(down.map(({ at }) => Math.round(at))).toEqual([20, 40, 60, 80, 100, 120, 140, 160, 180, 200, 220]);
    for (const { at, width } of down) expect(width).toBeCloseTo(Math.round(at) === 120 ? 2 : 1, 6);
  });

  it('of a dome are circles at equal distances about the zenith, and radii, the one ahead at the bottom', () => {
    const [size, radius] = [361, 180.5];
    const image = gridOf(domeLens(Math.PI, 0.4), LINES, size, size);
    /** Of the nearest line, by its distance: multiples of 15° are so many pixels apart. */
    const band = (angle: number, pixelsPerDegree: number): number => {
      const nearest = 15 * Math.round(angle / 15);
      const width = nearest === 0 ? 2 : 1;
      return Math.min(1, Math.max(0, width / 2 + 0.5 - Math.abs(angle - nearest) * pixelsPerDegree));
    };
    for (let y = 0; y < size; y += 2)
      for (let x = 0; x < size; x++) {
        const [right, down] = [x + 0.5 - radius, y + 0.5 - radius];
        const r = Math.hypot(right, down);
        // Nearer to the zenith lines are left out that would run together.
        if (r < 50 || r > radius - 2) continue;
        const height = 90 * (1 - r / radius);
        const bearing = (Math.atan2(right, down) * 180) / Math.PI;
        const wanted = Math.max(band(height, radius / 90), band(bearing, (r * Math.PI) / 180));
        expect(Math.abs(image.at(x, y)[2]! - wanted), `at ${x}, ${y}`).toBeLessThan(0.01);
      }
    expect(image.at(2, 2)).toEqual([0, 0, 0]);
  });

  it('of a perspective picture has the horizon in the middle, and equal bearings at tan φ', () => {
    const [width, height, fovY] = [401, 201, Math.PI / 2];
    const image = gridOf(perspective(fovY), LINES, width, height);
    expect(linesAlong(column(image, 190)).some(({ at }) => Math.abs(at - height / 2) < 0.05)).toBe(true);
    const bearings = linesAlong(row(image, 95)).map(
      ({ at }) => Math.atan((at - width / 2) / (height / 2)) * (180 / Math.PI),
    );
    for (const bearing of bearings) expect(Math.abs(bearing - 15 * Math.round(bearing / 15))).toBeLessThan(0.2);
    expect(bearings).toHaveLength(9);
  });

  it('has a border around the safe part: a circle of a dome, else a rectangle', () => {
    const onBorder = (image: FloatImage, x: number, y: number) => image.at(x, y)[0] === 1;
    const dome = gridOf(domeLens(Math.PI, 0), [90, 0.8, 1, 2], 401, 401);
    for (const angle of [0.3, 1.1, 2.6, 4])
      expect(
        onBorder(dome, Math.floor(200.5 + 160.4 * Math.cos(angle)), Math.floor(200.5 + 160.4 * Math.sin(angle))),
      ).toBe(true);
    const around = gridOf({ kind: 'equirectangular' }, [90, 0.8, 1, 2], 400, 200);
    for (const [x, y] of [
      [40, 77],
      [359, 33],
      [133, 20],
      [222, 179],
    ] as const)
      expect(onBorder(around, x, y)).toBe(true);
  });
});
