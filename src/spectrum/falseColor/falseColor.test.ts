import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { invert, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { decodeSrgb, encodeSrgb } from '../display/srgb.ts';
import { coolWarm, type Rgb8, viridis } from './colorMaps.ts';
import {
  colorRamp,
  FALSE_COLOR_QUANTITIES,
  falseColor,
  NO_VALUE_COLOR,
  positionOnScale,
  type ValueRange,
  valueAtPosition,
} from './falseColor.ts';
import { fitScale, tickDigits, ticksOf } from './falseColorScale.ts';

const largest = (a: Rgb8, b: readonly number[]): number => Math.max(...a.map((value, k) => Math.abs(value - b[k]!)));

describe('the colour maps', () => {
  it('viridis agrees with matplotlib', () => {
    // Colours 0, 64, 128, 192 and 255 of matplotlib's table.
    const known = ['440154', '3b528b', '21918c', '5ec962', 'fde725'];
    [0, 64, 128, 192, 255].forEach((i, n) => {
      const wanted = [0, 2, 4].map((at) => Number.parseInt(known[n]!.slice(at, at + 2), 16));
      expect(largest(viridis(i / 255), wanted)).toBeLessThanOrEqual(1);
    });
  });

  it('cool to warm agrees with its author’s formula', () => {
    for (let i = 0; i <= 64; i++) expect(largest(coolWarm(i / 64), moreland(i / 64))).toBeLessThanOrEqual(4);
  });
});

/** Moreland 2009, section 4: interpolation in Msh, the polar form of CIE Lab, through a white of M = 88. */
function moreland(part: number): readonly number[] {
  const [cool, warm] = [
    [59, 76, 192],
    [180, 4, 38],
  ].map((rgb) => mshOf(rgb as unknown as Vec3)) as [Vec3, Vec3];
  const middle = Math.max(cool[0], warm[0], 88);
  const end = part < 0.5 ? cool : warm;
  const white: Vec3 = [middle, 0, turned(end, middle)];
  const way = part < 0.5 ? 1 - 2 * part : 2 * part - 1;
  return rgbOfMsh(white.map((value, k) => value + way * (end[k]! - value)) as unknown as Vec3);
}

function turned([m, s, h]: Vec3, middle: number): number {
  if (m >= middle) return h;
  const spin = (s * Math.sqrt(middle ** 2 - m ** 2)) / (m * Math.sin(s));
  return h > -Math.PI / 3 ? h + spin : h - spin;
}

const XYZ = [0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505];
const WHITE: Vec3 = [0.9505, 1, 1.089];

function mshOf(rgb: Vec3): Vec3 {
  const xyz = transform(XYZ, rgb.map((value) => decodeSrgb(value / 255)) as unknown as Vec3);
  const [x, y, z] = xyz.map((value, k) => {
    const t = value / WHITE[k]!;
    return t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116;
  }) as [number, number, number];
  const [L, a, b] = [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  const m = Math.hypot(L, a, b);
  return [m, Math.acos(L / m), Math.atan2(b, a)];
}

function rgbOfMsh([m, s, h]: Vec3): number[] {
  const [L, a, b] = [m * Math.cos(s), m * Math.sin(s) * Math.cos(h), m * Math.sin(s) * Math.sin(h)];
  const y = (L + 16) / 116;
  const f = [a / 500 + y, y, y - b / 200];
  const xyz = f.map((t, k) => WHITE[k]! * (t ** 3 > 0.008856 ? t ** 3 : (t - 16 / 116) / 7.787)) as unknown as Vec3;
  return transform(invert(XYZ)!, xyz).map((value) => Math.round(255 * encodeSrgb(value)));
}

const shift = fc.double({ min: 1e-3, max: 1e3, noNaN: true });

describe('a scale', () => {
  it.each(FALSE_COLOR_QUANTITIES)('of %s is inverted by its inverse', (kind) => {
    const scale: ValueRange = { from: 0.1, to: 20 };
    fc.assert(
      fc.property(fc.double({ min: 0, max: 1, noNaN: true }), (part) => {
        expect(positionOnScale(kind, valueAtPosition(kind, part, scale), scale)).toBeCloseTo(part, 9);
      }),
    );
  });

  it.each(FALSE_COLOR_QUANTITIES)('of %s has round ticks, and colours that change throughout', (kind) => {
    const scale = fitScale(kind, kind === 'emission-time' ? [-7.3, -0.2, Number.NaN] : [0.4, 1, 1.3]);
    const ticks = ticksOf(kind, scale);
    expect(ticks.length).toBeGreaterThan(2);
    ticks.forEach((tick, i) => {
      expect(positionOnScale(kind, tick, scale)).toBeGreaterThanOrEqual(-1e-9);
      expect(positionOnScale(kind, tick, scale)).toBeLessThanOrEqual(1 + 1e-9);
      if (i > 0) expect(tick).toBeGreaterThan(ticks[i - 1]!);
    });
    expect(new Set(colorRamp(kind, scale, 33).map(String)).size).toBeGreaterThan(5);
  });

  it('has tick labels that are distinct, with no more digits than needed', () => {
    const read = (most: number): string[] => {
      const ticks = ticksOf('doppler', fitScale('doppler', [1, most]));
      return ticks.map((tick) => String(Number(tick.toPrecision(tickDigits(ticks)))));
    };
    expect(read(1)).toEqual(['0.98', '0.99', '1', '1.01', '1.02']);
    expect(read(1.04)).toEqual(['0.952', '0.976', '1', '1.02', '1.05']);
    expect(read(3)).toEqual(['0.33', '0.58', '1', '1.7', '3']);
  });

  it('of D is centred at 1: grey there, blue for blueshifts', () => {
    fc.assert(
      fc.property(fc.array(shift, { minLength: 1 }), (shifts) => {
        const scale = fitScale('doppler', shifts);
        expect(positionOnScale('doppler', 1, scale)).toBeCloseTo(0.5, 12);
        expect(scale.to).toBeGreaterThanOrEqual(Math.min(...shifts));
      }),
    );
    const colors = { kind: 'doppler', from: 0.5, to: 2 } as const;
    const [r, , b] = falseColor(colors, 1.9);
    expect(b).toBeGreaterThan(2 * r);
    const [red, , blue] = falseColor(colors, 0.55);
    expect(red).toBeGreaterThan(2 * blue);
    expect(falseColor(colors, Number.NaN)).toEqual(NO_VALUE_COLOR);
  });

  it('of time ends now, unless all emission times are long ago', () => {
    expect(fitScale('emission-time', [-7.3, -0.2])).toEqual({ from: -8, to: 0 });
    expect(fitScale('emission-time', [-51, -49])).toEqual({ from: -51, to: -49 });
    expect(fitScale('emission-time', [])).toMatchObject({ to: 0 });
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: -1e6, max: 1e6, noNaN: true, noDefaultInfinity: true }), { minLength: 1 }),
        (times) => {
          const { from, to } = fitScale('emission-time', times);
          expect(to).toBeGreaterThan(from);
        },
      ),
    );
  });

  it('of light spans powers of ten, at most six decades', () => {
    expect(fitScale('radiance', [0.03, 0.2, 7])).toEqual({ from: 0.01, to: 10 });
    const wide = fitScale('radiance', [0, 1e-12, 1]);
    expect(wide.to / wide.from).toBeCloseTo(1e6, 3);
    expect(fitScale('radiance', [0])).toMatchObject({ from: expect.any(Number) });
  });
});
