import { clamp, dot, float, select } from 'three/tsl';
import { NANOMETRE, VISIBLE, WAVELENGTHS } from '../../spectrum/observer/standardObserver.ts';
import type { HalfTable } from '../tables/halfAtlas.ts';
import type { Float, Vec3, Vec4 } from '../types.ts';

/**
 * Linear sRGB of a spectral line of radiance 1 that has the wavelength `surface` [m] at a filter and `seen` [m] at the observer. The filter is
 * (r, g, b, its value outside the visible); `own`: use the fourth value there, else the ends of the basis.
 * `observer`: two rows over `WAVELENGTHS`, the linear sRGB and the filter basis at each (observerTable.ts).
 */
export const lineColor = (observer: HalfTable, surface: Float, seen: Float, filter: Vec4, own: boolean): Vec3 => {
  const row = (k: number, wavelength: Float): Vec3 => {
    const place = clamp(coordinateOf(wavelength), 0, WAVELENGTHS.length - 1);
    return observer.sampleLinear(place.add(0.5), float(k + 0.5)).xyz;
  };
  const within = dot(row(1, surface), filter.xyz);
  const share = own ? select(isVisible(surface), within, filter.w) : within;
  return row(0, seen).mul(select(isVisible(seen), share, 0));
};

/** 0 at the first of `WAVELENGTHS`, 1 at the second. */
const coordinateOf = (wavelength: Float): Float => wavelength.div(NANOMETRE).sub(WAVELENGTHS[0] / NANOMETRE);

const isVisible = (wavelength: Float) =>
  wavelength.greaterThanEqual(VISIBLE[0]).and(wavelength.lessThanEqual(VISIBLE[1]));
