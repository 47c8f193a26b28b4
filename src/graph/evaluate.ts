import type { GraphDocument, GraphNode } from './document.ts';
import {
  type Cancellation,
  NodeRefusal,
  type NodeType,
  type Problem,
  type Progress,
  type Registry,
  resolveParams,
  type Work,
} from './nodeType.ts';
import { reaches } from './validate.ts';

export type NodeResult =
  | { readonly status: 'done'; readonly outputs: Readonly<Record<string, unknown>> }
  | { readonly status: 'failed'; readonly problem: Problem }
  /** A node before it failed. */
  | { readonly status: 'blocked'; readonly by: string };

export interface Evaluation {
  readonly target: NodeResult;
  /** Of every node that the target needs. */
  readonly results: ReadonlyMap<string, NodeResult>;
}

/** Thrown out of an evaluation that was cancelled. */
export class CancelledError extends Error {
  constructor() {
    super('cancelled');
    this.name = 'CancelledError';
  }
}

interface Run<Services> {
  readonly document: GraphDocument;
  readonly work: Omit<Work<Services>, 'progress'>;
  readonly progress: (node: string, ...report: Parameters<Progress>) => void;
  readonly settled: Map<string, Promise<Keyed>>;
}

interface Keyed {
  readonly key: number;
  readonly result: NodeResult;
}

/**
 * Evaluates what a node needs and nothing else. A result is kept under the content that made it (type, parameters and the
 * keys of its inputs), so that an edit re-evaluates only what depends on it, and an undo finds the old result again.
 */
export class Evaluator<Services> {
  readonly #registry: Registry<Services>;
  readonly #capacity: number;
  /** Content → a small number that stands for it: exact, where a hash might collide. */
  readonly #keys = new Map<string, number>();
  /** Least recently used first. */
  readonly #cache = new Map<number, NodeResult>();
  /** Work under way: a second evaluation that needs the same content waits for the first one's. */
  readonly #pending = new Map<number, Promise<NodeResult>>();

  constructor(registry: Registry<Services>, capacity = 16) {
    this.#registry = registry;
    this.#capacity = capacity;
  }

  async evaluate(
    document: GraphDocument,
    target: string,
    services: Services,
    options: { signal?: Cancellation; progress?: Run<Services>['progress'] } = {},
  ): Promise<Evaluation> {
    const run: Run<Services> = {
      document,
      work: { services, signal: options.signal },
      progress: options.progress ?? (() => {}),
      settled: new Map(),
    };
    const { result } = await this.#settle(run, target);
    const results = new Map<string, NodeResult>();
    for (const [id, settled] of run.settled) results.set(id, (await settled).result);
    return { target: result, results };
  }

  #settle(run: Run<Services>, id: string): Promise<Keyed> {
    const known = run.settled.get(id);
    if (known) return known;
    const settled = this.#compute(run, id);
    run.settled.set(id, settled);
    return settled;
  }

  async #compute(run: Run<Services>, id: string): Promise<Keyed> {
    const node = run.document.nodes[id];
    const type = node && this.#registry[node.type];
    if (!node || !type) return failure('graph.unknown-node', id, `there is no node "${node?.type ?? id}"`);
    if (inCycle(run.document, id)) return failure('graph.cycle', id, 'the node feeds itself: remove one of the edges');
    const sources = await this.#inputs(run, id, type);
    if ('result' in sources) return sources;
    const key = this.#keyOf(node, sources.keys);
    const known = this.#recall(key);
    if (known) return { key, result: known };
    const pending = this.#pending.get(key) ?? this.#run(run, id, node, type, sources.values, key);
    this.#pending.set(key, pending);
    try {
      return { key, result: await pending };
    } finally {
      this.#pending.delete(key);
    }
  }

  async #inputs(run: Run<Services>, id: string, type: NodeType<Services>) {
    const keys: [string, number, string][] = [];
    const values: Record<string, unknown> = {};
    for (const [name, socket] of Object.entries(type.inputs)) {
      const edge = run.document.edges[`${id}.${name}`];
      if (!edge && socket.optional) continue;
      if (!edge) return failure('graph.input', id, `connect something to "${name}" (${socket.type})`);
      const { key, result } = await this.#settle(run, edge.from.node);
      if (result.status !== 'done') {
        return { key: -1, result: { status: 'blocked', by: edge.from.node } as const };
      }
      keys.push([name, key, edge.from.output]);
      values[name] = result.outputs[edge.from.output];
    }
    return { keys, values };
  }

  async #run(
    run: Run<Services>,
    id: string,
    node: GraphNode,
    type: NodeType<Services>,
    inputs: Record<string, unknown>,
    key: number,
  ): Promise<NodeResult> {
    if (run.work.signal?.aborted) throw new CancelledError();
    const progress: Progress = (part, what) => run.progress(id, part, what);
    try {
      const outputs = await type.evaluate(inputs, resolveParams(type, node.params), {
        ...run.work,
        node: id,
        progress,
      });
      return this.#remember(key, { status: 'done', outputs });
    } catch (error) {
      if (run.work.signal?.aborted || error instanceof CancelledError) throw new CancelledError();
      const result: NodeResult = { status: 'failed', problem: problemOf(error, id) };
      // A refusal follows from the content; anything else (a network that is down) may go better next time.
      return error instanceof NodeRefusal ? this.#remember(key, result) : result;
    }
  }

  #keyOf(node: GraphNode, inputs: readonly [string, number, string][]): number {
    const params = Object.entries(node.params).sort(([a], [b]) => (a < b ? -1 : 1));
    const content = JSON.stringify([node.type, params, inputs]);
    const key = this.#keys.get(content) ?? this.#keys.size;
    this.#keys.set(content, key);
    return key;
  }

  #recall(key: number): NodeResult | undefined {
    const result = this.#cache.get(key);
    if (result) this.#remember(key, result);
    return result;
  }

  #remember(key: number, result: NodeResult): NodeResult {
    this.#cache.delete(key);
    this.#cache.set(key, result);
    for (const oldest of this.#cache.keys()) {
      if (this.#cache.size <= this.#capacity) break;
      this.#cache.delete(oldest);
    }
    return result;
  }
}

const failure = (code: string, place: string, message: string): Keyed => ({
  key: -1,
  result: { status: 'failed', problem: { severity: 'error', code, place, message } },
});

const problemOf = (error: unknown, node: string): Problem =>
  error instanceof NodeRefusal
    ? error.problem
    : {
        severity: 'error',
        code: 'graph.evaluation',
        place: node,
        message: error instanceof Error ? error.message : String(error),
      };

/** Whether the node is one of its own ancestors. */
const inCycle = (document: GraphDocument, id: string): boolean =>
  Object.values(document.edges).some((edge) => edge.from.node === id && reaches(document, edge.to.node, id));
