import type * as mat4 from '../../../../math/mat4.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { corrected, type InstanceTransform, matrixOf } from './instanceTransforms.ts';
import type { InstanceIndexRun, PointInstance, PointInstances } from './pointInstances.ts';

/** Cost of one evaluation relative to a transform op. */
const COST = 4;

/** Time codes to which instances with velocities are extrapolated beyond their samples. */
export interface ExtrapolationRange {
  readonly start: number;
  readonly end: number;
}

/**
 * Path of one instance in its instancer. Between samples it is extrapolated by velocities, corrected linearly to meet
 * the next sample: jumps at samples would be faster than light.
 */
export function instanceTransform(
  population: PointInstances,
  instance: PointInstance,
  range: ExtrapolationRange,
): StageTransform {
  const times = timesOf(population, instance, range);
  const matrixAt = (time: number): mat4.Mat4 => matrixOf(transformAt(population, instance, time));
  if (times.length < 2) {
    const fixed = matrixAt(times[0] ?? range.start);
    return { times: NO_TIMES, cost: 1, matrixAt: () => fixed };
  }
  const { isStraight } = population.transforms;
  return { times, cost: COST, isStraight, isBudgeted: true, matrixAt: (time) => matrixAt(time ?? range.start) };
}

const NO_TIMES = new Float64Array(0);

function timesOf(
  { times, transforms }: PointInstances,
  { birth, death, indexRuns }: PointInstance,
  { start, end }: ExtrapolationRange,
) {
  const [{ count }] = indexRuns;
  const [first, last] = [times[0] ?? start, times[times.length - 1] ?? start];
  const extrapolatedFrom = transforms.isExtrapolated(count, first) ? Math.min(start, first) : first;
  const extrapolatedTo = transforms.isExtrapolated(indexRuns[indexRuns.length - 1].count, last)
    ? Math.max(end, last)
    : last;
  if (extrapolatedFrom === first && extrapolatedTo === last && birth === -Infinity && death === Infinity) return times;
  const all = new Set([extrapolatedFrom, ...times, extrapolatedTo, birth, death].filter(Number.isFinite));
  return Float64Array.from(all)
    .sort()
    .filter((t) => t >= birth && t <= death);
}

function transformAt(
  { transforms, times }: PointInstances,
  { indexRuns, death }: PointInstance,
  time: number,
): InstanceTransform {
  const k = lastBefore(times, time, death);
  const base = k < 0 ? time : times[k];
  const { index, count } = stepAt(indexRuns, base);
  const isExtrapolated = transforms.isExtrapolated(count, base);
  const at = (t: number): InstanceTransform => transforms.at(index, count, t, base);
  // At its death the arrays may already have another size.
  if (time >= death && !isExtrapolated && transforms.sizeMismatches(count, time).length > 0) return at(base);
  const next = times[k + 1];
  if (k < 0 || next === undefined || next >= death || time === base) return at(time);
  const then = stepAt(indexRuns, next);
  if (then.index === index && !isExtrapolated) return at(time);
  return corrected(at(time), at(next), transforms.at(then.index, then.count, next), (time - base) / (next - base));
}

/** Index of the last of the times that is ≤ `time` and < `death`; −1 if none. */
function lastBefore(times: Float64Array, time: number, death: number): number {
  return lastIndexWhere(times.length, (k) => times[k] <= time && times[k] < death);
}

const stepAt = (steps: readonly InstanceIndexRun[], time: number): InstanceIndexRun =>
  steps[
    Math.max(
      0,
      lastIndexWhere(steps.length, (k) => steps[k].from <= time),
    )
  ];

/** The largest index below `count` for which `holds`, which must hold for all smaller ones; −1 if none. Binary search. */
function lastIndexWhere(count: number, holds: (k: number) => boolean): number {
  let [low, high] = [-1, count];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (holds(middle)) low = middle;
    else high = middle;
  }
  return low;
}
