import type { Books } from '../../dynamics/books.ts';
import type { Run } from '../state/runs.ts';

/** What is plotted over time. */
export const QUANTITIES = [
  'change',
  'total',
  'kinetic',
  'potential',
  'fastest',
  'momentum',
  'angularMomentum',
] as const;
export type Quantity = (typeof QUANTITIES)[number];

/** Of each frame; `unit`: see there. */
export function valuesOf(books: Books, quantity: Quantity, unit: string): Float64Array {
  const { total, speedOfLight, fastest } = books;
  if (quantity === 'change') return total.map((energy) => energy - (total[0] ?? 0));
  if (quantity === 'fastest') return unit === 'c' ? fastest.map((speed) => speed / speedOfLight) : fastest;
  if (quantity === 'momentum' || quantity === 'angularMomentum') return lengths(books[quantity]);
  return books[quantity];
}

/** Where one of the runs knows no speed of light, none is told in its units. */
export function unitOf(quantity: Quantity, runs: readonly Run[]): string {
  if (quantity === 'momentum') return 'kg m/s';
  if (quantity === 'angularMomentum') return 'kg m²/s';
  if (quantity !== 'fastest') return 'J';
  return runs.every(({ books }) => Number.isFinite(books.speedOfLight)) ? 'c' : 'm/s';
}

const lengths = (vectors: Float64Array): Float64Array =>
  Float64Array.from({ length: vectors.length / 3 }, (_, i) =>
    Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!),
  );

/** What a table tells of a run. */
export interface Figures {
  /** The largest change of the energy, in units of the largest kinetic energy; undefined where nothing moved. */
  readonly drift: number | undefined;
  /** [m/s] */
  readonly fastest: number;
  /** Of the last frame [s]. */
  readonly until: number;
}

export function figuresOf(books: Books): Figures {
  const change = largest(valuesOf(books, 'change', 'J'));
  const kinetic = largest(books.kinetic);
  return {
    drift: kinetic > 0 ? change / kinetic : undefined,
    fastest: largest(books.fastest),
    until: books.times.at(-1) ?? 0,
  };
}

const largest = (values: Float64Array): number => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/** The place of the last frame that is not after t; −1: all are. */
export function frameAt(times: Float64Array, t: number): number {
  let [from, to] = [0, times.length];
  while (from < to) {
    const middle = (from + to) >> 1;
    if (times[middle]! <= t) from = middle + 1;
    else to = middle;
  }
  return from - 1;
}

/** What a logarithmic axis can show of a value. */
export const onLogarithmicAxis = (values: Float64Array): (number | null)[] =>
  Array.from(values, (value) => (value === 0 || !Number.isFinite(value) ? null : Math.abs(value)));
