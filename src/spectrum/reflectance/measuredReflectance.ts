import { interpolateTable } from '../observer/standardObserver.ts';

/** Reflectance 0 … 1 at `first`, `first + step` … [m], at least two values, linear between them and constant outside. */
export interface MeasuredReflectance {
  /** Wavelength of the first value [m]. */
  readonly first: number;
  /** From value to value [m]. */
  readonly step: number;
  /** Reflectances, 0 … 1, at least two. */
  readonly values: readonly number[];
}

/** The reflectance at a wavelength [m]. */
export function measuredReflectanceAt({ first, step, values }: MeasuredReflectance, wavelength: number): number {
  return interpolateTable(values, Math.min(Math.max((wavelength - first) / step, 0), values.length - 1));
}
