import type { RunRecord } from '../../dynamics/runRecord.ts';
import { samplesUntil } from '../../physics/worldLines/samples.ts';
import type { SimulationRun } from '../state/simulationRuns.ts';

/** Quantities that can be plotted over time. */
export const QUANTITIES = [
  'change',
  'drift',
  'total',
  'kinetic',
  'potential',
  'dragLoss',
  'fastest',
  'momentum',
  'angularMomentum',
] as const;
export type RunQuantity = (typeof QUANTITIES)[number];

/** Values of a quantity, one per frame, in `unit` (see `unitOf`). */
export function valuesOf(record: RunRecord, quantity: RunQuantity, unit: string): Float64Array {
  const { total, speedOfLight, fastest, hasKinematic } = record;
  const { dragLoss = total.map(() => Number.NaN) } = record;
  if (quantity === 'change') return total.map((energy) => energy - (total[0] ?? 0));
  if (quantity === 'drift')
    return total.map((energy, k) => (hasKinematic ? Number.NaN : energy + dragLoss[k]! - (total[0] ?? 0)));
  if (quantity === 'dragLoss') return dragLoss;
  if (quantity === 'fastest') return unit === 'c' ? fastest.map((speed) => speed / speedOfLight) : fastest;
  if (quantity === 'momentum' || quantity === 'angularMomentum') return lengths(record[quantity]);
  return record[quantity];
}

/** The unit for all runs together: relative to c only if every run has a speed of light. */
export function unitOf(quantity: RunQuantity, runs: readonly SimulationRun[]): string {
  if (quantity === 'momentum') return 'kg m/s';
  if (quantity === 'angularMomentum') return 'kg m²/s';
  if (quantity !== 'fastest') return 'J';
  return runs.every(({ record }) => Number.isFinite(record.speedOfLight)) ? 'c' : 'm/s';
}

const lengths = (vectors: Float64Array): Float64Array =>
  Float64Array.from({ length: vectors.length / 3 }, (_, i) =>
    Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!),
  );

/** Index of the last frame with time ≤ t; −1 if there is none. */
export const frameIndexAt = (times: Float64Array, t: number): number => samplesUntil(times, t) - 1;

/** Values for a linear axis; null where not finite. */
export const onLinearAxis = (values: Float64Array): (number | null)[] =>
  Array.from(values, (value) => (Number.isFinite(value) ? value : null));

/** Absolute values for a logarithmic axis; null where zero or not finite. */
export const onLogarithmicAxis = (values: Float64Array): (number | null)[] =>
  Array.from(values, (value) => (value === 0 || !Number.isFinite(value) ? null : Math.abs(value)));
