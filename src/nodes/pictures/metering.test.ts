import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import type { MeteringMode } from '../../scene/settings/settings.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import { METER_CELLS } from '../../scene/view/metering.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../../scene/view/view.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { logLuminance } from '../../spectrum/sources/planck.ts';
import { adaptExposure, exposureForMetering, meteredExposure } from './metering.ts';

const SIZE = { width: 3, height: 2 };
const places = METER_CELLS * METER_CELLS;
const filled = (luminance: number) => new Float32Array(places).fill(luminance);
const look = (beta: number, fovY = 1): ViewPoint => ({
  t: 0,
  position: [0, 0, 0],
  u: properVelocity([0, 0, -beta]),
  orientation: IDENTITY,
  lens: perspective(fovY),
});

describe('the metered exposure', () => {
  it('maps uniform light of any level to the same brightness', () => {
    fc.assert(
      fc.property(fc.double({ min: -30, max: 50, noNaN: true }), (stops) => {
        const exposure = meteredExposure(Float64Array.of(2 ** stops));
        expect(stops + exposure).toBeCloseTo(meteredExposure([1]), 9);
      }),
    );
  });

  it('is continuous: a hundredth of a stop of light is a hundredth of a stop of exposure', () => {
    const scene = Float64Array.from({ length: places }, (_, i) => 0.01 + Math.abs(Math.sin(i)) ** 3);
    for (let i = 0; i < 40; i++) {
      const [now, next] = [i, i + 1].map((k) => meteredExposure(scene.map((value) => value * 2 ** (k / 100))));
      expect(now! - next!).toBeCloseTo(0.01, 6);
    }
  });

  it('ignores small lights, black space and non-finite values', () => {
    const scene = filled(0.5);
    const before = meteredExposure(scene);
    scene.fill(1e6, 0, Math.floor(0.004 * places));
    expect(meteredExposure(scene)).toBeCloseTo(before, 9);
    const lit = meteredExposure([0.5, 0.2, 0.1]);
    expect(meteredExposure([0.5, 0.2, 0.1, 0, 0, 0, -1, Number.NaN])).toBeCloseTo(lit, 12);
    expect(meteredExposure(filled(0))).toBe(0);
    expect(Number.isFinite(meteredExposure([Number.POSITIVE_INFINITY, 1]))).toBe(true);
  });
});

it('small bright objects before a dark background are not overexposed', () => {
  const space = filled(0.004);
  space.fill(0.6, 0, 0.03 * places);
  const exposure = meteredExposure(space);
  expect(0.6 * 2 ** exposure).toBeGreaterThan(0.7);
  expect(0.6 * 2 ** exposure).toBeLessThan(1.3);
});

describe('the resting eye', () => {
  it('has the exposure of an observer at rest, at any velocity: the Doppler factor straight ahead is e^rapidity', () => {
    const narrow = 1e-4;
    const rest = exposureForMetering(
      'automatic',
      { luminance: filled(0.3) },
      [look(0, narrow)],
      DEFAULT_SETTINGS,
      SIZE,
    );
    for (const beta of [-0.5, 0.3, 0.8]) {
      const settings = { ...DEFAULT_SETTINGS, dopplerMix: 0 };
      const beamed = 0.3 * Math.exp(4 * Math.atanh(beta));
      const seen = { luminance: filled(beamed) };
      expect(exposureForMetering('resting-eye', seen, [look(beta, narrow)], settings, SIZE)).toBeCloseTo(rest, 4);
      expect(exposureForMetering('automatic', seen, [look(beta, narrow)], settings, SIZE)).toBeCloseTo(
        rest - (4 * Math.atanh(beta)) / Math.LN2,
        4,
      );
    }
  });

  it('predicts shifted daylight within a fifth of a stop, from half to five times the wavelengths', () => {
    const T = DAYLIGHT.temperature;
    for (const beta of [-0.6, -0.3, 0.3, 0.6, 0.9]) {
      const D = Math.exp(Math.atanh(beta));
      const seen = 0.3 * Math.exp(logLuminance(T * D) - logLuminance(T));
      const exposure = (how: MeteringMode, luminance: number, view: ViewPoint) =>
        exposureForMetering(how, { luminance: filled(luminance) }, [view], DEFAULT_SETTINGS, SIZE);
      const rest = exposure('automatic', 0.3, look(0, 1e-4));
      expect(Math.abs(exposure('resting-eye', seen, look(beta, 1e-4)) - rest)).toBeLessThan(0.2);
    }
  });

  it('is the automatic exposure at rest, and in views without light', () => {
    const luminance = Float32Array.from({ length: places }, (_, i) => (i % 17) / 10);
    const both = (view: ViewPoint, settings = DEFAULT_SETTINGS) =>
      (['resting-eye', 'automatic'] as const).map((how) =>
        exposureForMetering(how, { luminance }, [view], settings, SIZE),
      );
    for (const [eye, automatic] of [both(look(0)), both(look(0.9), { ...DEFAULT_SETTINGS, view: 'simultaneity' })])
      expect(eye).toBeCloseTo(automatic!, 6);
    const [eye, automatic] = both(look(0.9));
    expect(eye! - automatic!).toBeGreaterThan(2);
  });
});

it('manual exposure is only the user’s', () => {
  expect(exposureForMetering('manual', { luminance: filled(9) }, [look(0.9)], DEFAULT_SETTINGS, SIZE)).toBe(0);
});

it('adaptation does not depend on the frame rate', () => {
  const whole = adaptExposure(4, -2, 0.6);
  const steps = Array.from({ length: 60 }).reduce<number>((ev) => adaptExposure(ev, -2, 0.01), 4);
  expect(steps).toBeCloseTo(whole, 9);
  expect(adaptExposure(4, -2, 0)).toBe(4);
  expect(adaptExposure(4, -2, 10)).toBeCloseTo(-2, 9);
});

it('a panoramic picture is metered by solid angle: bright poles of an equirectangular one count as little as they are', () => {
  const view = { ...look(0), lens: { kind: 'equirectangular' } as const };
  const size = { width: 128, height: 64 };
  // Within 30° of the poles, a third of the rows, is 1 − cos 30° = 13 % of the sphere.
  const luminance = Float32Array.from({ length: places }, (_, i) => {
    const row = Math.floor(i / METER_CELLS);
    return Math.min(row, METER_CELLS - 1 - row) < METER_CELLS / 6 ? 8 : 0.25;
  });
  const metered = (views: readonly [ViewPoint]) =>
    exposureForMetering('automatic', { luminance }, views, { ...DEFAULT_SETTINGS, speedOfLight: 10 }, size);
  const [around, ahead] = [metered([view]), metered([look(0)])];
  // Sorted by light, the mean of 10 … 95 % of the weight: 87 % − 10 % at −2, 8 % at +3 stops.
  const share = 1 - Math.cos(Math.PI / 6);
  const middle = (-2 * (1 - share - 0.1) + 3 * (0.95 - (1 - share))) / 0.85;
  const highlights = 3;
  const expected = Math.min(Math.log2(0.4) - middle, Math.log2(1.25) - highlights);
  expect(Math.abs(around - expected)).toBeLessThan(0.05);
  expect(ahead).toBeLessThanOrEqual(around + 1e-9);
});
