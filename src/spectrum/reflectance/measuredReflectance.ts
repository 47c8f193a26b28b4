import { interpolateTable } from '../observer/standardObserver.ts';

/** Reflectance at `first`, `first + step` … [m], 0 … 1, two values at least, linear between them; before and after them it goes on as it ends. */
export interface MeasuredReflectance {
  readonly first: number;
  readonly step: number;
  readonly values: readonly number[];
}

/** At a wavelength [m]. */
export function measuredReflectanceAt({ first, step, values }: MeasuredReflectance, wavelength: number): number {
  return interpolateTable(values, Math.min(Math.max((wavelength - first) / step, 0), values.length - 1));
}
