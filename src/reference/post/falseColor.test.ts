import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { ZERO } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { type AovName, DEFAULT_SETTINGS } from '../../scene/view/view.ts';
import { FALSE_COLOR_QUANTITIES } from '../../spectrum/falseColor/falseColor.ts';
import { fitScale } from '../../spectrum/falseColor/falseColorScale.ts';
import { falseColorLegendHeight, withFalseColorLegend } from '../figures/falseColorLegend.ts';
import { createCanvas } from '../figures/pixelCanvas.ts';
import { AOVS_OF_FALSE_COLOR, type FalseColorInput, falseColorPicture, falseColorValues } from './falseColor.ts';

/** Two pixels at 10 s: a surface emitting at 7 s with D = 2, and sky ahead of an observer at 0.6 c. */
const input: FalseColorInput = {
  aovs: new Map<AovName, Float32Array>([
    ['object', Float32Array.of(1, 0)],
    ['doppler', Float32Array.of(2, 0)],
    ['emission_time', Float32Array.of(7, 0)],
    ['beauty', Float32Array.of(0.5, 0.5, 0.5, 2, 0, 0)],
  ]),
  views: [{ t: 10, position: ZERO, u: properVelocity([0, 0, -0.6]), orientation: IDENTITY, lens: perspective(1e-6) }],
  settings: DEFAULT_SETTINGS,
  width: 2,
  height: 1,
};

describe('false colours', () => {
  it('represent the pixel’s values, and the shift of the sky', () => {
    const values = (kind: (typeof FALSE_COLOR_QUANTITIES)[number]) => [...falseColorValues(kind, input)];
    expect(values('doppler')).toEqual([2, expect.closeTo(2, 6)]);
    expect(values('emission-time')).toEqual([-3, Number.NaN]);
    expect(values('radiance')).toEqual([0.5, expect.closeTo(2 * 0.2126, 6)]);
    expect(values('band')[0]).toBeCloseTo(1.1e-6, 12);
    expect(falseColorValues('doppler', { ...input, settings: { ...DEFAULT_SETTINGS, view: 'galilean' } })[1]).toBe(1);
  });

  it.each(FALSE_COLOR_QUANTITIES)('%s: a picture with a legend below, of even height', (kind) => {
    expect(AOVS_OF_FALSE_COLOR[kind].every((name) => input.aovs.has(name))).toBe(true);
    const values = falseColorValues(kind, input);
    const colors = { kind, ...fitScale(kind, values) };
    expect(falseColorPicture(colors, values, input).pixels).toHaveLength(8);
    for (const width of [40, 200, 1280]) {
      const whole = withFalseColorLegend(createCanvas(width, 20, [255, 0, 0]), colors);
      expect(whole.height).toBe(20 + falseColorLegendHeight(width, kind));
      expect(falseColorLegendHeight(width, kind) % 2).toBe(0);
      const shown = new Set<number>();
      for (let i = 4 * width * 20; i < whole.pixels.length; i += 4)
        shown.add((whole.pixels[i]! << 16) | (whole.pixels[i + 1]! << 8) | whole.pixels[i + 2]!);
      expect(shown.size).toBeGreaterThan(10);
    }
  });

  it('a band tints the picture: brighter light, brighter tint', () => {
    const colors = { kind: 'band', ...fitScale('band', []) } as const;
    const bright = (light: number) => {
      const aovs = new Map(input.aovs).set('beauty', Float32Array.of(light, light, light, 0, 0, 0));
      return falseColorPicture(colors, falseColorValues('band', input), { ...input, aovs }).pixels[0]!;
    };
    expect(bright(0.8)).toBeGreaterThan(1.5 * bright(0));
  });
});
