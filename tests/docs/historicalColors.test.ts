import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { transform } from '../../src/math/mat3.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { relativeLuminance } from '../../src/scene/view/metering.ts';
import { observedColor } from '../../src/spectrum/color/observerColor.ts';
import { SRGB_TO_XYZ } from '../../src/spectrum/display/rgbSpaces.ts';
import { RGB_COLOR_MODES, RGB_SHIFTS } from '../../src/spectrum/doppler/rgbShifts.ts';
import { filterFromRgb, WHITE_FILTER } from '../../src/spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT } from '../../src/spectrum/sources/lightSpectrum.ts';
import { deltaE2000, labOf } from '../support/deltaE.ts';

const PAGE = new URL('../../docs/guide/historical-colours.md', import.meta.url);
/** Linear sRGB of walls in daylight. */
const WALLS: readonly Vec3[] = [
  [0.8, 0.8, 0.8],
  [0.5, 0.06, 0.04],
  [0.6, 0.3, 0.06],
  [0.5, 0.45, 0.05],
  [0.08, 0.35, 0.07],
  [0.05, 0.1, 0.45],
  [0.3, 0.06, 0.35],
];
const SHIFTS = [0.7, 0.9, 1, 1.1, 1.3, 1.6] as const;

const lab = (rgb: Vec3): Vec3 =>
  labOf(transform(SRGB_TO_XYZ, rgb.map((x) => Math.max(x, 0)) as unknown as Vec3), WHITE);
const WHITE = transform(SRGB_TO_XYZ, [1, 1, 1]);

/** ΔE₀₀ of two colours, both at the luminance 0.4, and the ratio of their luminances. */
function errors(found: Vec3, truth: Vec3): readonly [number, number] {
  const [a, b] = [found, truth].map((rgb) => relativeLuminance(...rgb));
  if (!(a! > 1e-9)) return [Number.NaN, 0];
  const at = (rgb: Vec3, light: number) => lab(rgb.map((x) => (0.4 * x) / light) as unknown as Vec3);
  const [p, q] = [at(found, a!), at(truth, b!)];
  return [deltaE2000(p, q), a! / b!];
}

const mean = (values: readonly number[]) => values.reduce((sum, x) => sum + x, 0) / values.length;

it('docs/guide/historical-colours.md has the errors of the modes against the spectral integral', () => {
  const rows = SHIFTS.map((D) => {
    const cells = RGB_COLOR_MODES.map((mode) => {
      const all = WALLS.map((wall) => {
        const truth = observedColor(filterFromRgb(wall), WHITE_FILTER, DAYLIGHT, 1, D);
        return errors(RGB_SHIFTS[mode](wall, D, 1), truth);
      });
      const seen = all.map(([error]) => error).filter((error) => !Number.isNaN(error));
      const ratios = all.map(([, ratio]) => ratio);
      const color = seen.length === 0 ? 'black' : mean(seen).toFixed(0);
      return `${color} | ${Math.min(...ratios).toFixed(2)} … ${Math.max(...ratios).toFixed(2)}`;
    });
    return `| ${D} | ${cells.join(' | ')} |`;
  });
  expect(readFileSync(PAGE, 'utf8')).toContain(rows.join('\n'));
});
