import { byStrength, type Node } from './node.ts';
import type { Work } from './work.ts';

/** What is to be done at a node, the most urgent first: selections of variants may depend on all that comes before. */
const TASKS = [
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
export type TaskKind = (typeof TASKS)[number];

export interface Task {
  readonly kind: TaskKind;
  readonly node: Node;
  /** Of a task about a variant set: its name and its place among the sets of the site. */
  readonly set?: string;
  readonly number?: number;
}

/** What is to be done, the most urgent first; of one kind in the order in which it came, but for variants and classes. */
export class TaskList {
  private readonly work: Work;
  private readonly byKind = new Map<TaskKind, Task[]>();
  /** Sets that no selection was found for: they are asked again when a variant has brought new opinions. */
  private undecided: Task[] = [];

  constructor(work: Work) {
    this.work = work;
  }

  add(task: Task): void {
    const tasks = this.byKind.get(task.kind);
    if (!tasks) this.byKind.set(task.kind, [task]);
    else if (task.kind !== 'impliedClasses' || !tasks.some((t) => t.node === task.node)) tasks.push(task);
  }

  postpone(task: Task): void {
    this.undecided.push(task);
  }

  /** A variant was added: what had no selection may have one now. */
  retryVariants(): void {
    const asked = [...(this.byKind.get('fallbackVariant') ?? []), ...this.undecided];
    this.byKind.delete('fallbackVariant');
    this.undecided = [];
    for (const task of asked) this.add({ ...task, kind: 'variant' });
  }

  take(): Task | undefined {
    if (this.byKind.size === 0) return undefined;
    for (const kind of TASKS) {
      const tasks = this.byKind.get(kind);
      if (!tasks) continue;
      const [task] = tasks.splice(this.firstOf(tasks), 1);
      if (tasks.length === 0) this.byKind.delete(kind);
      return task;
    }
    return undefined;
  }

  /** The place of the task that comes first among those of one kind. */
  private firstOf(tasks: readonly Task[]): number {
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

const NO_ORDER: ReadonlyMap<Node, number> = new Map();

const placesByStrength = (root: Node): ReadonlyMap<Node, number> =>
  new Map(byStrength(root).map((node, place) => [node, place]));

function comesBefore(a: Task, b: Task, order: ReadonlyMap<Node, number>): boolean {
  // Classes are implied upwards: from below first.
  if (a.kind === 'impliedClasses') return a.node.serial > b.node.serial;
  if (a.node === b.node) return a.set !== undefined && a.number! < b.number!;
  return a.set !== undefined && order.get(a.node)! < order.get(b.node)!;
}
