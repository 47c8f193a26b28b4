import { byStrength, type Node } from './node.ts';

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

const urgency = new Map<TaskKind, number>(TASKS.map((kind, i) => [kind, i]));

export class TaskList {
  private tasks: Task[] = [];
  /** Sets that no selection was found for: they are asked again when a variant has brought new opinions. */
  private readonly undecided: Task[] = [];

  add(task: Task): void {
    const again =
      task.kind === 'impliedClasses' && this.tasks.some((t) => t.kind === task.kind && t.node === task.node);
    if (!again) this.tasks.push(task);
  }

  postpone(task: Task): void {
    this.undecided.push(task);
  }

  /** A variant was added: what had no selection may have one now. */
  retryVariants(): void {
    const asked = [...this.tasks.filter((t) => t.kind === 'fallbackVariant'), ...this.undecided.splice(0)];
    this.tasks = this.tasks.filter((t) => t.kind !== 'fallbackVariant');
    for (const task of asked) this.tasks.push({ ...task, kind: 'variant' });
  }

  take(): Task | undefined {
    let best = 0;
    for (let i = 1; i < this.tasks.length; i++) if (comesBefore(this.tasks[i], this.tasks[best])) best = i;
    return this.tasks.splice(best, 1)[0];
  }
}

function comesBefore(a: Task, b: Task): boolean {
  if (a.kind !== b.kind) return urgency.get(a.kind)! < urgency.get(b.kind)!;
  // Classes are implied upwards: from below first.
  if (a.kind === 'impliedClasses') return a.node.serial > b.node.serial;
  if (a.set === undefined || b.set === undefined) return false;
  if (a.node === b.node) return a.number! < b.number!;
  const order = byStrength(a.node.root);
  return order.indexOf(a.node) < order.indexOf(b.node);
}
