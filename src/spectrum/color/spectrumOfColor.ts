import { invert, type Mat3, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { DAYLIGHT, type ThermalSpectrum } from '../sources/lightSpectrum.ts';
import { colorOfSpectrum, XYZ_TO_RENDER_SRGB } from './observerColor.ts';

/** Temperatures that are inferred from a colour [K]. From `WARM_TEMPERATURE` down to the lower end the inferred temperature fades to daylight's. */
const RANGE = [1000, 25_000] as const;
const WARM_TEMPERATURE = 1500;
/** Distances from the Planckian locus in CIE 1960 u, v: below the first a colour is taken for a blackbody, above the second for filtered daylight. */
const LOCUS_DISTANCE = [0.01, 0.03] as const;
/** Differences of ln T from daylight's: below the first the light is daylight. */
const DAYLIGHT_RANGE = [0.01, 0.02] as const;

/**
 * The spectrum assumed for light of which only the linear sRGB colour is known. Near the Planckian locus (daylight is 0.003 from it) it is a
 * blackbody of the correlated colour temperature, which shifted by D is one of T·D. Far from the locus it is daylight; `lightFilter` makes the rest of
 * the colour. Between the two ln T is interpolated, so that similar colours have similar spectra: ln T = ln 6504 K + share · (ln T_c − ln 6504 K), with
 * a share of 1 near the locus and 0 far from it and beyond its red end. docs/physics.md §7.7. Correlated colour temperature: CIE 015:2018, §9.5, nearest in
 * u, v of CIE 1960.
 */
export function spectrumOfColor(color: Vec3): ThermalSpectrum {
  const place = uvChromaticity(color);
  if (!place) return DAYLIGHT;
  const { temperature, distance } = nearestOnLocus(place);
  const apart = Math.log(temperature / DAYLIGHT.temperature);
  const share =
    smoothstep(LOCUS_DISTANCE[1], LOCUS_DISTANCE[0], distance) *
    smoothstep(RANGE[0], WARM_TEMPERATURE, temperature) *
    smoothstep(DAYLIGHT_RANGE[0], DAYLIGHT_RANGE[1], Math.abs(apart));
  return share > 0 ? { kind: 'thermal', temperature: DAYLIGHT.temperature * Math.exp(share * apart) } : DAYLIGHT;
}

/** Hermite step: 0 at `from`, 1 at `to`. */
function smoothstep(from: number, to: number, x: number): number {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}

type UvChromaticity = readonly [u: number, v: number];

const TO_XYZ: Mat3 = invert(XYZ_TO_RENDER_SRGB) ?? XYZ_TO_RENDER_SRGB;

/** u, v of CIE 1960; undefined for black. */
function uvChromaticity(color: Vec3): UvChromaticity | undefined {
  const [X, Y, Z] = transform(TO_XYZ, color);
  const sum = X + 15 * Y + 3 * Z;
  return sum > 0 ? [(4 * X) / sum, (6 * Y) / sum] : undefined;
}

interface LocusPoint {
  readonly mired: number;
  readonly chromaticity: UvChromaticity;
}

/** Step of 10⁶/T along the locus; the chord between two points is within 2e-5 of it. */
const MIRED = 5;
let locus: readonly LocusPoint[] | undefined;

function planckianLocus(): readonly LocusPoint[] {
  const [hot, cold] = [1e6 / RANGE[1], 1e6 / RANGE[0]];
  return Array.from({ length: Math.round((cold - hot) / MIRED) + 1 }, (_, i) => {
    const mired = hot + i * MIRED;
    const white = colorOfSpectrum({ kind: 'thermal', temperature: 1e6 / mired });
    return { mired, chromaticity: uvChromaticity(white) ?? [0, 0] };
  });
}

/** The point of the locus that is nearest to a chromaticity. */
function nearestOnLocus(place: UvChromaticity): { readonly temperature: number; readonly distance: number } {
  locus ??= planckianLocus();
  let [distance, found] = [Number.POSITIVE_INFINITY, 0];
  for (let i = 0; i + 1 < locus.length; i++) {
    const [a, b] = [locus[i], locus[i + 1]];
    const [x, y] = [b.chromaticity[0] - a.chromaticity[0], b.chromaticity[1] - a.chromaticity[1]];
    const along = (place[0] - a.chromaticity[0]) * x + (place[1] - a.chromaticity[1]) * y;
    const t = Math.min(Math.max(along / (x * x + y * y), 0), 1);
    const off = Math.hypot(place[0] - a.chromaticity[0] - t * x, place[1] - a.chromaticity[1] - t * y);
    if (off < distance) [distance, found] = [off, a.mired + t * MIRED];
  }
  return { temperature: 1e6 / found, distance };
}
