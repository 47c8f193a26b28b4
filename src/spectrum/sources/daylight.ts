import { NANOMETRE } from '../observer/standardObserver.ts';
import { S0, S1, S2 } from '../tables/daylightSeries.ts';
import type { SampledSpectrum } from './lightSpectrum.ts';

/** Range of the CIE D series [K]. */
const RANGE = [4000, 25_000] as const;

/**
 * The CIE D series: daylight of a correlated colour temperature [K], clamped to 4000…25,000, from 300 to 830 nm; D65 is
 * that of 6504 K. Unlike a blackbody it has the absorption bands of the sun and the air. docs/physics.md §7.9; CIE 015:2018, §4.1.2, eq. 4.6–4.10.
 * @example
 * const d65 = daylightSpectrum(6504);
 * d65.first; // 300.0e-9 m
 */
export function daylightSpectrum(temperature: number): SampledSpectrum {
  const [x, y] = daylightChromaticity(Math.min(Math.max(temperature, RANGE[0]), RANGE[1]));
  const M = 0.0241 + 0.2562 * x - 0.7341 * y;
  const M1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / M;
  const M2 = (0.03 - 31.4424 * x + 30.0717 * y) / M;
  return {
    kind: 'sampled',
    first: 300 * NANOMETRE,
    step: 5 * NANOMETRE,
    values: S0.map((mean, i) => Math.max(mean + M1 * S1[i] + M2 * S2[i], 0)),
  };
}

/** CIE 1931 x, y of the daylight locus. */
function daylightChromaticity(T: number): [x: number, y: number] {
  const t = 1000 / T;
  const x =
    T <= 7000
      ? 0.244063 + 0.09911 * t + 2.9678 * t ** 2 - 4.607 * t ** 3
      : 0.23704 + 0.24748 * t + 1.9018 * t ** 2 - 2.0064 * t ** 3;
  return [x, -3 * x ** 2 + 2.87 * x - 0.275];
}
