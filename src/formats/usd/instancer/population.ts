import { attributeOf, numbersAt, sampleTimes, valueAt } from '../attributes.ts';
import { report, type StageContext, targetsOf } from '../context.ts';
import type { PrimSpec } from '../layer.ts';
import { unionOfTimes } from '../xformOps.ts';
import { InstanceTransforms } from './transforms.ts';

/** From a time on, an instance has this place in the arrays. */
export interface Step {
  readonly from: number;
  readonly index: number;
  /** Elements of the arrays then. */
  readonly count: number;
}

/** One instance for as long as it is there without a break, with one prototype. */
export interface Instance {
  /** Its id, else its place in the arrays; with what tells it from an earlier one of this name. */
  readonly label: string;
  /** Place among the prototypes. */
  readonly prototype: number;
  /** Time codes. */
  readonly birth: number;
  readonly death: number;
  readonly steps: readonly Step[];
}

/** What a PointInstancer says. */
export interface Population {
  readonly instances: readonly Instance[];
  /** Paths. */
  readonly prototypes: readonly string[];
  readonly transforms: InstanceTransforms;
  /** Codes at which anything of it changes. */
  readonly times: Float64Array;
}

/** What there is from one time to the next. */
interface Epoch {
  readonly from: number;
  readonly to: number;
  readonly prototypes: ArrayLike<number>;
  readonly labels: readonly string[] | undefined;
  readonly hidden: ReadonlySet<string>;
}

/** Places in arrays, at all times together: a small file can say so many times that there are many. */
const MAX_STEPS = 2 ** 22;

export function populationOf(context: StageContext, prim: PrimSpec): Population {
  const transforms = new InstanceTransforms(prim, context.codesPerSecond);
  const prototypes = targetsOf(prim, 'prototypes');
  const topology = unionOfTimes(TOPOLOGY.map((name) => sampleTimes(attributeOf(prim, name))));
  const times = unionOfTimes([topology, transforms.times]);
  const epochs = epochsOf(context, prim, topology);
  const census = new Census(prototypes.length);
  for (const epoch of epochs) if (fits(context, prim, transforms, epoch, times)) census.take(epoch);
  const { outside } = census;
  if (outside) {
    const message = `protoIndices[${outside.index}] is ${outside.value}, but there are ${prototypes.length} prototypes; ${outside.count} such instances are left out`;
    report(context, 'warning', 'usd.instancer', prim.path, message);
  }
  return { instances: census.finish(), prototypes, transforms, times };
}

const TOPOLOGY = ['protoIndices', 'ids', 'invisibleIds'];

function epochsOf(context: StageContext, prim: PrimSpec, topology: Float64Array): Epoch[] {
  const starts = topology.length > 0 ? [...topology] : [context.startCode];
  let steps = 0;
  const epochs: Epoch[] = [];
  for (const [k, start] of starts.entries()) {
    const prototypes = numbersAt(prim, 'protoIndices', start) ?? [];
    steps += prototypes.length;
    if (k > 0 && steps > MAX_STEPS) {
      const message = `it has more than ${MAX_STEPS} instances at all its times together; from t = ${start} on it is held`;
      report(context, 'warning', 'usd.instancer', prim.path, message);
      return [...epochs.slice(0, -1), { ...epochs[k - 1], to: Infinity }];
    }
    epochs.push({
      from: k === 0 ? -Infinity : start,
      to: starts[k + 1] ?? Infinity,
      prototypes,
      labels: labelsAt(context, prim, start, prototypes.length),
      hidden: new Set([...inactiveIds(prim), ...idsAt(prim, 'invisibleIds', start)]),
    });
  }
  return epochs;
}

/** The ids, where they tell the instances apart. */
function labelsAt(context: StageContext, prim: PrimSpec, time: number, count: number): string[] | undefined {
  const ids = idsAt(prim, 'ids', time);
  if (ids.length === 0) return undefined;
  if (ids.length === count && new Set(ids).size === count) return ids;
  const message =
    ids.length === count ? 'two of its ids are the same' : `it has ${ids.length} ids for ${count} instances`;
  report(context, 'warning', 'usd.instancer', prim.path, `${message}; its instances are known by their places instead`);
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

/** Whether an epoch's arrays are as long as they must be, wherever they change; says so of one that is not. */
function fits(
  context: StageContext,
  prim: PrimSpec,
  transforms: InstanceTransforms,
  { from, to, prototypes }: Epoch,
  times: Float64Array,
): boolean {
  const count = prototypes.length;
  const first = Number.isFinite(from) ? from : Math.min(context.startCode, times[0] ?? context.startCode);
  let fit = true;
  for (const time of [first, ...times.filter((t) => t > from && t < to)]) {
    for (const [name, has] of transforms.misfits(count, time)) {
      const left = name === 'positions' ? 'they are left out' : `${name} are left out`;
      const message = `${name} has ${has} values at t = ${time}, for ${count} instances; ${left}`;
      report(context, 'warning', 'usd.instancer', prim.path, message);
      if (name === 'positions') fit = false;
    }
    if (!fit) break;
  }
  return fit;
}

interface OpenRun {
  readonly prototype: number;
  readonly birth: number;
  readonly steps: Step[];
  end: number;
}

/** Follows instances from epoch to epoch, by their labels. */
class Census {
  private readonly prototypes: number;
  private readonly done: Instance[] = [];
  private readonly open = new Map<string, OpenRun>();
  private readonly named = new Map<string, number>();
  /** Instances of prototypes that are not there: the first, and how many. */
  outside: { readonly index: number; readonly value: number; count: number } | undefined;

  constructor(prototypes: number) {
    this.prototypes = prototypes;
  }

  take({ from, to, prototypes, labels, hidden }: Epoch): void {
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

  finish(): readonly Instance[] {
    for (const [label, run] of this.open) this.close(label, run);
    return this.done;
  }

  private step(label: string, prototype: number, step: Step, to: number): void {
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

  private close(label: string, { prototype, birth, steps, end }: OpenRun): void {
    this.open.delete(label);
    const before = this.named.get(label) ?? 0;
    this.named.set(label, before + 1);
    const unique = before === 0 ? label : `${label}.${before + 1}`;
    this.done.push({ label: unique, prototype, birth, death: end, steps });
  }
}
