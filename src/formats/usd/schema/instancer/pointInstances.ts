import { msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, sampleTimes, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { InstanceTransforms } from './instanceTransforms.ts';

/** Array index of an instance from a time code on. */
export interface InstanceIndexRun {
  readonly from: number;
  readonly index: number;
  /** Length of the arrays. */
  readonly count: number;
}

/** One instance over a contiguous interval, with one prototype. */
export interface PointInstance {
  /** Its id, else its array index; with a suffix if an earlier instance has the same. */
  readonly label: string;
  /** Index in `prototypes`. */
  readonly prototype: number;
  /** Time codes. */
  readonly birth: number;
  readonly death: number;
  readonly indexRuns: readonly InstanceIndexRun[];
}

/** The instances of a PointInstancer over time. */
export interface PointInstances {
  readonly instances: readonly PointInstance[];
  /** Paths. */
  readonly prototypes: readonly string[];
  readonly transforms: InstanceTransforms;
  /** Time codes at which anything changes. */
  readonly times: Float64Array;
}

/** An interval of constant topology. */
interface TopologyInterval {
  readonly from: number;
  readonly to: number;
  readonly prototypes: ArrayLike<number>;
  readonly labels: readonly string[] | undefined;
  readonly hidden: ReadonlySet<string>;
}

/** Maximum number of array elements over all times: a small file can hold many times. */
const MAX_INSTANCE_SAMPLES = 2 ** 22;

export function pointInstancesOf(context: StageContext, prim: PrimSpec): PointInstances {
  const transforms = new InstanceTransforms(prim, context.codesPerSecond);
  const prototypes = targetsOf(prim, 'prototypes');
  const topology = unionOfTimes(TOPOLOGY.map((name) => sampleTimes(attributeOf(prim, name))));
  const times = unionOfTimes([topology, transforms.times]);
  const intervals = topologyIntervals(context, prim, topology);
  const tracker = new InstanceTracker(prototypes.length);
  const told = new Set<string>();
  for (const interval of intervals) if (fits(context, prim, transforms, interval, times, told)) tracker.add(interval);
  const { outside } = tracker;
  if (outside) {
    const message = msg`protoIndices[${outside.index}] is ${outside.value}, but there are ${prototypes.length} prototypes; ${outside.count} such instances are left out`;
    report(context, 'warning', 'usd.instancer', prim.path, message);
  }
  return { instances: tracker.finish(), prototypes, transforms, times };
}

const TOPOLOGY = ['protoIndices', 'ids', 'invisibleIds'];

function topologyIntervals(context: StageContext, prim: PrimSpec, topology: Float64Array): TopologyInterval[] {
  const starts = topology.length > 0 ? [...topology] : [context.startCode];
  let steps = 0;
  const intervals: TopologyInterval[] = [];
  for (const [k, start] of starts.entries()) {
    const prototypes = numbersAt(prim, 'protoIndices', start) ?? [];
    steps += prototypes.length;
    if (k > 0 && steps > MAX_INSTANCE_SAMPLES) {
      const message = msg`it has more than ${MAX_INSTANCE_SAMPLES} instances at all its times together; from t = ${start} on it is held`;
      report(context, 'warning', 'usd.instancer', prim.path, message);
      return [...intervals.slice(0, -1), { ...intervals[k - 1], to: Infinity }];
    }
    intervals.push({
      from: k === 0 ? -Infinity : start,
      to: starts[k + 1] ?? Infinity,
      prototypes,
      labels: labelsAt(context, prim, start, prototypes.length),
      hidden: new Set([...inactiveIds(prim), ...idsAt(prim, 'invisibleIds', start)]),
    });
  }
  return intervals;
}

/** The ids, if they are unique and complete. */
function labelsAt(context: StageContext, prim: PrimSpec, time: number, count: number): string[] | undefined {
  const ids = idsAt(prim, 'ids', time);
  if (ids.length === 0) return undefined;
  if (ids.length === count && new Set(ids).size === count) return ids;
  const message =
    ids.length === count ? msg`two of its ids are the same` : msg`it has ${ids.length} ids for ${count} instances`;
  report(
    context,
    'warning',
    'usd.instancer',
    prim.path,
    msg`${message}; its instances are known by their places instead`,
  );
  return undefined;
}

function idsAt(prim: PrimSpec, name: string, time: number): string[] {
  const value = valueAt(attributeOf(prim, name), time);
  return value?.type === 'int64[]' ? Array.from(value.data, String) : [];
}

function inactiveIds(prim: PrimSpec): string[] {
  const value = prim.metadata.get('inactiveIds');
  return value?.type === 'integers' ? (value.op.explicit ?? []).map(String) : [];
}

/** Whether the positions have the right length throughout an interval; reports arrays that do not, each once. `told`: the names of those so far. */
function fits(
  context: StageContext,
  prim: PrimSpec,
  transforms: InstanceTransforms,
  { from, to, prototypes }: TopologyInterval,
  times: Float64Array,
  told: Set<string>,
): boolean {
  const count = prototypes.length;
  const first = Number.isFinite(from) ? from : Math.min(context.startCode, times[0] ?? context.startCode);
  let fit = true;
  for (const time of [first, ...times.filter((t) => t > from && t < to)]) {
    for (const [name, has] of transforms.sizeMismatches(count, time)) {
      const left = name === 'positions' ? msg`they are left out` : msg`${name} are left out`;
      const message = msg`${name} has ${has} values at t = ${time}, for ${count} instances; ${left}`;
      if (!told.has(name)) report(context, 'warning', 'usd.instancer', prim.path, message);
      told.add(name);
      if (name === 'positions') fit = false;
    }
    if (!fit) break;
  }
  return fit;
}

interface OpenInstance {
  readonly prototype: number;
  readonly birth: number;
  readonly steps: InstanceIndexRun[];
  end: number;
}

/** Tracks instances across intervals by their labels. */
class InstanceTracker {
  private readonly prototypes: number;
  private readonly done: PointInstance[] = [];
  private readonly open = new Map<string, OpenInstance>();
  private readonly named = new Map<string, number>();
  /** Instances with invalid prototype indices: the first, and their number. */
  outside: { readonly index: number; readonly value: number; count: number } | undefined;

  constructor(prototypes: number) {
    this.prototypes = prototypes;
  }

  add({ from, to, prototypes, labels, hidden }: TopologyInterval): void {
    const count = prototypes.length;
    for (let index = 0; index < count; index++) {
      const label = labels?.[index] ?? `${index}`;
      if (hidden.has(label)) continue;
      const prototype = prototypes[index];
      if (!(prototype >= 0 && prototype < this.prototypes)) {
        this.outside ??= { index, value: prototype, count: 0 };
        this.outside.count++;
        continue;
      }
      this.step(label, prototype, { from, index, count }, to);
    }
    for (const [label, run] of this.open) if (run.end <= from) this.close(label, run);
  }

  finish(): readonly PointInstance[] {
    for (const [label, run] of this.open) this.close(label, run);
    return this.done;
  }

  private step(label: string, prototype: number, step: InstanceIndexRun, to: number): void {
    let run = this.open.get(label);
    if (run && (run.prototype !== prototype || run.end !== step.from)) {
      this.close(label, run);
      run = undefined;
    }
    if (!run) {
      run = { prototype, birth: step.from, steps: [], end: to };
      this.open.set(label, run);
    }
    run.steps.push(step);
    run.end = to;
  }

  private close(label: string, { prototype, birth, steps, end }: OpenInstance): void {
    this.open.delete(label);
    const before = this.named.get(label) ?? 0;
    this.named.set(label, before + 1);
    const unique = before === 0 ? label : `${label}.${before + 1}`;
    this.done.push({ label: unique, prototype, birth, death: end, indexRuns: steps });
  }
}
