import { msg } from '../../messages/message.ts';
import { conversion } from '../analysis/conversion.ts';
import type { FlatAlias, FlatGraph, FlatNode, FlatSource } from '../analysis/flatten.ts';
import { socketsOfType } from '../analysis/sockets.ts';
import { CYCLE_MESSAGE } from '../analysis/validate.ts';
import { own } from '../document/document.ts';
import { ANY, type NodeType, valueError } from '../nodeType.ts';
import { drivenValue, type ParamValues, paramFailure, type StoredParams, storedParams } from './params.ts';
import { failure, type NodeResult } from './resultCache.ts';

/** A node's work with all its inputs available. */
export interface NodeCall<Services> {
  readonly id: string;
  readonly type: NodeType<Services>;
  readonly params: ParamValues;
  /** Identifies the parameters' values. */
  readonly paramsKey: string;
  readonly inputs: Readonly<Record<string, unknown>>;
  /** Whether any input is or depends on an interim result. */
  readonly interim: boolean;
}

/** Performs a node's work, or returns a cached result. */
export type PerformNode<Services> = (call: NodeCall<Services>) => NodeResult | Promise<NodeResult>;

/** A node that is being resolved. */
interface NodeTask<Services> {
  readonly id: string;
  readonly node?: FlatNode;
  readonly type?: NodeType<Services>;
  /** Parameters come first, since they may determine which inputs are needed. */
  params?: StoredParams;
  /** Number of pending results. */
  waiting: number;
  readonly waiters: NodeTask<Services>[];
  result?: NodeResult;
  /** Type of its generic sockets. */
  generic: string;
  /** Whether any input so far is interim. */
  interim: boolean;
}

/**
 * One evaluation: determines what the targets need, and starts each node's work when all its inputs are available.
 * Nodes do not call each other, so chains can have any length; synchronous work runs at once, asynchronous work
 * concurrently.
 */
export class Scheduler<Services> {
  private readonly graph: FlatGraph;
  private readonly types: Readonly<Record<string, NodeType<Services>>>;
  private readonly perform: PerformNode<Services>;
  private readonly tasks = new Map<string, NodeTask<Services>>();
  private readonly ready: NodeTask<Services>[] = [];
  private underWay = 0;
  private end: { readonly done: () => void; readonly fail: (error: unknown) => void } | undefined;

  constructor(graph: FlatGraph, types: Readonly<Record<string, NodeType<Services>>>, perform: PerformNode<Services>) {
    this.graph = graph;
    this.types = types;
    this.perform = perform;
  }

  async run(targets: readonly string[]): Promise<ReadonlyMap<string, NodeResult>> {
    const ended = new Promise<void>((done, fail) => {
      this.end = { done, fail };
    });
    for (const target of targets) {
      const alias = this.graph.aliases.get(target);
      if (!alias) this.task(target);
      else if (alias.source.kind === 'output') this.task(alias.source.node);
    }
    this.work();
    await ended;
    const results = new Map([...this.tasks].map(([id, task]) => [id, task.result!]));
    for (const target of targets) {
      const alias = this.graph.aliases.get(target);
      if (alias) results.set(target, this.resultOf(alias, target));
    }
    return results;
  }

  /** Result of a node that flattening removed: that of its source. */
  private resultOf({ source, output }: FlatAlias, target: string): NodeResult {
    if (source.kind === 'nothing') return failure('graph.input', target, source.why);
    const { result } = this.tasks.get(source.node)!;
    if (result?.status !== 'done') return blockedBy(source.node, result);
    return { ...result, outputs: { [output]: result.outputs[source.output] } };
  }

  private task(id: string): NodeTask<Services> {
    const known = this.tasks.get(id);
    if (known) return known;
    const node = this.graph.nodes.get(id);
    const type = node && own(this.types, node.type);
    const task: NodeTask<Services> = { id, node, type, waiting: 0, waiters: [], generic: ANY, interim: false };
    this.tasks.set(id, task);
    this.ready.push(task);
    return task;
  }

  private work(): void {
    try {
      for (let task = this.ready.pop(); task; task = this.ready.pop()) this.advance(task);
      if (this.underWay === 0) this.end?.done();
    } catch (error) {
      this.ready.length = 0;
      this.end?.fail(error);
    }
  }

  private advance(task: NodeTask<Services>): void {
    const { id, node, type } = task;
    if (!node || !type) {
      this.settle(task, failure('graph.unknown-node', id, msg`there is no node "${node?.type ?? id}"`));
    } else if (this.graph.cycles.has(id)) {
      this.settle(task, failure('graph.cycle', id, CYCLE_MESSAGE));
    } else {
      const call = this.callOf(task, node, type);
      if (call && 'status' in call) this.settle(task, call);
      else if (call) this.start(task, call);
    }
  }

  /** The node's call, or its failure; undefined while it has to wait. */
  private callOf(
    task: NodeTask<Services>,
    node: FlatNode,
    type: NodeType<Services>,
  ): NodeCall<Services> | NodeResult | undefined {
    if (!task.params) {
      if (this.waits(task, node, drivenParams(node, type))) return undefined;
      const params = this.params(task, node, type);
      if ('status' in params) return params;
      task.params = params;
    }
    const { values: params, key: paramsKey } = task.params;
    const names = type.needs?.(params) ?? Object.keys(type.inputs);
    if (this.waits(task, node, names)) return undefined;
    const found = this.inputs(task, node, type, names);
    if ('status' in found) return found;
    return { id: node.id, type, params, paramsKey, inputs: found.values, interim: task.interim };
  }

  private start(task: NodeTask<Services>, call: NodeCall<Services>): void {
    const result = this.perform(call);
    if (!(result instanceof Promise)) {
      this.settle(task, result);
      return;
    }
    this.underWay++;
    const settle = (settled: NodeResult): void => {
      this.underWay--;
      this.settle(task, settled);
      this.work();
    };
    result.then(settle, (error) => this.end?.fail(error));
  }

  private settle(task: NodeTask<Services>, result: NodeResult): void {
    task.result = result;
    for (const waiter of task.waiters) if (--waiter.waiting === 0) this.ready.push(waiter);
  }

  /** Whether results of these inputs are pending; the task is resumed when they arrive. */
  private waits(task: NodeTask<Services>, node: FlatNode, names: readonly string[]): boolean {
    for (const name of names) {
      for (const source of node.inputs.get(name) ?? []) {
        if (source.kind === 'nothing') continue;
        const needed = this.task(source.node);
        if (needed.result) continue;
        needed.waiters.push(task);
        task.waiting++;
      }
    }
    return task.waiting > 0;
  }

  private params(task: NodeTask<Services>, node: FlatNode, type: NodeType<Services>): StoredParams | NodeResult {
    const known = storedParams(type, node.params);
    if (known.refusal) return paramFailure(node.id, type, known.refusal.param, known.refusal.message);
    const names = drivenParams(node, type);
    if (names.length === 0) return known;
    const values: Record<string, ParamValues[string]> = { ...known.values };
    for (const name of names) {
      const [source] = node.inputs.get(name)!;
      if (source?.kind !== 'output') continue;
      const found = this.value(source, task, name, socketsOfType(type).inputs[name]!.type);
      if ('status' in found) return found;
      const value = drivenValue(type.params[name]!, found.value);
      const message = valueError(type.params[name]!, value);
      if (message) return failure('graph.param', `${node.id}.${name}`, msg`${message}; an edge brings it`);
      values[name] = value;
    }
    return { values, key: JSON.stringify(values) };
  }

  private inputs(task: NodeTask<Services>, node: FlatNode, type: NodeType<Services>, names: readonly string[]) {
    const values: Record<string, unknown> = {};
    for (const name of names) {
      const socket = type.inputs[name]!;
      const sources = node.inputs.get(name) ?? [];
      const found: unknown[] = [];
      for (const source of sources) {
        if (source.kind === 'nothing') continue;
        const value = this.value(source, task, name, socket.type);
        if ('status' in value) return value;
        if (socket.type === ANY) task.generic = value.type;
        found.push(value.value);
      }
      if (found.length === 0 && !socket.optional) return missingInput(node.id, name, socket.type, sources);
      if (socket.many) values[name] = found;
      else if (found.length > 0) values[name] = found[0];
    }
    return { values };
  }

  /** The value of a settled source, converted to the wanted type, with its original type. */
  private value(
    source: OutputSource,
    task: NodeTask<Services>,
    input: string,
    wanted: string,
  ): { value: unknown; type: string } | NodeResult {
    const { result, type, generic } = this.tasks.get(source.node)!;
    if (result?.status !== 'done') return blockedBy(source.node, result);
    if (result.interim) task.interim = true;
    const from = `${source.node}.${source.output}`;
    const declared = type && own(type.outputs, source.output)?.type;
    if (declared === undefined) return failure('graph.edge', task.id, msg`there is no output ${from}; connect another`);
    const actual = declared === ANY ? generic : declared;
    const convert = conversion(actual, wanted);
    if (convert) return { value: convert(result.outputs[source.output]), type: actual };
    const message = msg`${actual} (${from}) does not fit ${wanted} (${input}); connect something else`;
    return failure('graph.edge', task.id, message);
  }
}

type OutputSource = Extract<FlatSource, { kind: 'output' }>;

const blockedBy = (by: string, result: NodeResult | undefined): NodeResult =>
  result?.status === 'blocked' ? result : { status: 'blocked', by };

/** Names of the driven parameters. */
const drivenParams = (node: FlatNode, type: NodeType<never>): string[] =>
  [...node.inputs.keys()].filter((name) => !own(type.inputs, name) && own(type.params, name));

function missingInput(node: string, name: string, type: string, [source]: readonly FlatSource[]): NodeResult {
  const why = source?.kind === 'nothing' ? msg`${source.why}, or connect something else to "${name}"` : undefined;
  return failure('graph.input', node, why ?? msg`connect something to "${name}" (${type})`);
}
