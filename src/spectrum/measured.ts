import { valueAt } from './cie1931.ts';

/** Reflectance at `first`, `first + step` … [m], 0 … 1, two values at least, linear between them; before and after them it goes on as it ends. */
export interface Reflectance {
  readonly first: number;
  readonly step: number;
  readonly values: readonly number[];
}

/** At a wavelength [m]. */
export function measuredAt({ first, step, values }: Reflectance, wavelength: number): number {
  return valueAt(values, Math.min(Math.max((wavelength - first) / step, 0), values.length - 1));
}
