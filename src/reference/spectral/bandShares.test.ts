import { describe, expect, it } from 'vitest';
import { DIRECT, lambert, lit, look, SPECTRAL } from '../../../tests/support/lightKit.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { plane } from '../../scene/mesh/primitives.ts';
import type { DistantLight } from '../../scene/types.ts';
import { relativeLuminance } from '../../scene/view/metering.ts';
import { bandShares, SPECTRAL_BANDS } from '../../spectrum/falseColor/spectralBands.ts';
import { type SampledSpectrum, spectralRadiance } from '../../spectrum/sources/lightSpectrum.ts';

const STEP = 1e-9;
const [FIRST, COUNT] = [50e-9, 6000];

/** A spectrum with equal energy at all wavelengths of one band, and none outside. */
const within = (from: number, to: number): SampledSpectrum => ({
  kind: 'sampled',
  first: FIRST,
  step: STEP,
  values: Array.from({ length: COUNT }, (_, i) => Number(FIRST + i * STEP >= from && FIRST + i * STEP < to)),
});

const spectra = SPECTRAL_BANDS.map(({ from }, i) => within(from, SPECTRAL_BANDS[i + 1]?.from ?? 1));

/** Luminance, per radiance at one wavelength, that an observer at β sees straight ahead of a white wall lit by a sun of one band. */
function seen(spectrum: SampledSpectrum, beta: Vec3): number {
  const sun: DistantLight = { kind: 'distant', path: '/sun', direction: [0, -1, 0], color: [1, 1, 1], spectrum };
  const wall = { mesh: plane(900, 900), material: lambert(1) };
  const scene = lit([wall], [sun]);
  const samples = 256;
  const eye = { position: [0, 5, 0], u: properVelocity(beta) } as const;
  const light = look(scene, eye, [0, -1, 0], DIRECT, samples, { settings: SPECTRAL });
  const lit1 = spectrum.values.findIndex((value) => value > 0);
  return relativeLuminance(...light) / spectralRadiance(spectrum, FIRST + (lit1 + 1) * STEP);
}

describe('the fraction of each band that is seen', () => {
  it.each([-0.8, -0.5, -0.2, 0, 0.2, 0.35, 0.5, 0.8, 0.95])('agrees with the spectral reference at %s c', (speed) => {
    const parts = spectra.map((spectrum) => seen(spectrum, [0, -speed, 0]));
    const whole = parts.reduce((a, b) => a + b);
    const D = Math.sqrt((1 + speed) / (1 - speed));
    bandShares(D).forEach((share, i) => {
      expect(Math.abs(parts[i]! / whole - share)).toBeLessThan(0.01);
    });
  });
});
