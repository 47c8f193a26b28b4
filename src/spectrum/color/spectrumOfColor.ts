import { invert, type Mat3, transform } from '../../math/mat3.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { DAYLIGHT, type ThermalSpectrum } from '../sources/lightSpectrum.ts';
import { colorOfSpectrum, XYZ_TO_RENDER_SRGB } from './observerColor.ts';

/** Temperatures that a colour alone may mean [K]; from the first on, redder light is what a filter leaves, as far as the second. */
const RANGE = [1000, 25_000] as const;
const WARM_TEMPERATURE = 1500;
/** Distances from the locus of blackbodies in CIE 1960 u, v: as far as the first a colour is one of them, a little tinted; from the second on it is a filter's. */
const LOCUS_DISTANCE = [0.01, 0.03] as const;
/** Of ln T beside daylight's: as far as the first it is daylight. */
const DAYLIGHT_RANGE = [0.01, 0.02] as const;

/**
 * What light of a linear sRGB colour is made of that says nothing else. Near the locus of blackbodies, and so of daylight (0.003 from it), it is a blackbody of the correlated
 * colour temperature: shifted by D it is one of T·D, and never greenish. Daylight behind a filter is what is far from it. Between the two T goes over from one to the other, so that light
 * of colours that are hardly different is hardly different: ln T is ln 6504 K plus a share of what lies between, 1 near the locus, 0 far from it and beyond its red end, where
 * sRGB ends, too. What remains of the colour is left to `lightFilter`. Source of the correlated colour temperature: CIE 015:2018, §9.5, nearest in u, v of CIE 1960.
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

/** 0 at the first, 1 at the second, and smooth. */
function smoothstep(from: number, to: number, x: number): number {
  const t = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return t * t * (3 - 2 * t);
}

type UvChromaticity = readonly [u: number, v: number];

const TO_XYZ: Mat3 = invert(XYZ_TO_RENDER_SRGB) ?? XYZ_TO_RENDER_SRGB;

/** u, v of CIE 1960; undefined of darkness. */
function uvChromaticity(color: Vec3): UvChromaticity | undefined {
  const [X, Y, Z] = transform(TO_XYZ, color);
  const sum = X + 15 * Y + 3 * Z;
  return sum > 0 ? [(4 * X) / sum, (6 * Y) / sum] : undefined;
}

interface LocusPoint {
  readonly mired: number;
  readonly chromaticity: UvChromaticity;
}

/** Steps of 10⁶/T along the locus; between two it is taken to be straight, within 2e-5. */
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

/** The place of the locus that is nearest to a colour. */
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
