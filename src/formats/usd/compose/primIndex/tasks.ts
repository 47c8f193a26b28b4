import type { CompositionBudget } from './compositionBudget.ts';
import { type PrimIndexNode, strengthOrder } from './primIndexNode.ts';

/** Tasks of a node by priority: variant selections may depend on all earlier kinds. */
const TASK_ORDER = [
  'relocate',
  'impliedRelocate',
  'references',
  'payloads',
  'inherits',
  'impliedClasses',
  'specializes',
  'variantSets',
  'variant',
  'fallbackVariant',
] as const;
export type IndexTaskKind = (typeof TASK_ORDER)[number];

export interface IndexTask {
  readonly kind: IndexTaskKind;
  readonly node: PrimIndexNode;
  /** Variant set of the task, and its index among the sets of the site. */
  readonly set?: string;
  readonly number?: number;
}

/** A priority queue of tasks; FIFO within one kind, except variants and classes. */
export class TaskList {
  private readonly work: CompositionBudget;
  private readonly byKind = new Map<IndexTaskKind, IndexTask[]>();
  /** Variant sets without a selection yet; retried when a variant has added opinions. */
  private undecided: IndexTask[] = [];

  constructor(work: CompositionBudget) {
    this.work = work;
  }

  add(task: IndexTask): void {
    const tasks = this.byKind.get(task.kind);
    if (!tasks) this.byKind.set(task.kind, [task]);
    else if (task.kind !== 'impliedClasses' || !tasks.some((t) => t.node === task.node)) tasks.push(task);
  }

  postpone(task: IndexTask): void {
    this.undecided.push(task);
  }

  /** Retries undecided sets after a variant was added. */
  retryVariants(): void {
    const asked = [...(this.byKind.get('fallbackVariant') ?? []), ...this.undecided];
    this.byKind.delete('fallbackVariant');
    this.undecided = [];
    for (const task of asked) this.add({ ...task, kind: 'variant' });
  }

  take(): IndexTask | undefined {
    if (this.byKind.size === 0) return undefined;
    for (const kind of TASK_ORDER) {
      const tasks = this.byKind.get(kind);
      if (!tasks) continue;
      const [task] = tasks.splice(this.firstOf(tasks), 1);
      if (tasks.length === 0) this.byKind.delete(kind);
      return task;
    }
    return undefined;
  }

  /** Index of the first task of one kind. */
  private firstOf(tasks: readonly IndexTask[]): number {
    const [{ kind, node, set }] = tasks;
    if (set === undefined && kind !== 'impliedClasses') return 0;
    this.work.spend(tasks.length);
    const order = set === undefined || tasks.every((t) => t.node === node) ? NO_ORDER : placesByStrength(node.root);
    this.work.spend(order.size);
    let first = 0;
    for (let i = 1; i < tasks.length; i++) if (comesBefore(tasks[i], tasks[first], order)) first = i;
    return first;
  }
}

const NO_ORDER: ReadonlyMap<PrimIndexNode, number> = new Map();

const placesByStrength = (root: PrimIndexNode): ReadonlyMap<PrimIndexNode, number> =>
  new Map(strengthOrder(root).map((node, place) => [node, place]));

function comesBefore(a: IndexTask, b: IndexTask, order: ReadonlyMap<PrimIndexNode, number>): boolean {
  // Classes are implied upwards: deepest node first.
  if (a.kind === 'impliedClasses') return a.node.serial > b.node.serial;
  if (a.node === b.node) return a.set !== undefined && a.number! < b.number!;
  return a.set !== undefined && order.get(a.node)! < order.get(b.node)!;
}
