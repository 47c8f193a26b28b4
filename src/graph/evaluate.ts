import { DocumentError, type GraphDocument } from './document.ts';
import { type FlatGraph, flatten } from './flatten.ts';
import { type Cancellation, NodeRefusal, type Problem, type Progress, type Registry } from './nodeType.ts';
import { at, failure, type NodeResult, Results } from './results.ts';
import { type Call, Run } from './run.ts';

export interface Evaluation {
  /** Of the first node that was asked for. */
  readonly target: NodeResult;
  /** Of every node that the targets need; in groups by `outer/inner`. */
  readonly results: ReadonlyMap<string, NodeResult>;
}

/** Thrown out of an evaluation that was cancelled. */
export class CancelledError extends Error {
  constructor() {
    super('cancelled');
    this.name = 'CancelledError';
  }
}

export interface EvaluateOptions {
  readonly signal?: Cancellation;
  readonly progress?: (node: string, ...report: Parameters<Progress>) => void;
}

/** A heavy node's work, in words that can be sent to another thread. */
export interface HeavyOrder {
  readonly type: string;
  readonly node: string;
  readonly inputs: Readonly<Record<string, unknown>>;
  readonly params: Call<never>['params'];
}

/** Has heavy nodes evaluated elsewhere. */
export type RunHeavy = (
  order: HeavyOrder,
  work: { readonly signal?: Cancellation; readonly progress: Progress },
) => Promise<Readonly<Record<string, unknown>>>;

export interface EvaluatorOptions {
  /** How many results are kept beside those of the latest evaluation, for an undo to find. */
  readonly capacity?: number;
  /** Without: heavy nodes are evaluated where all others are. */
  readonly heavy?: RunHeavy;
}

/** What an evaluation brings along. */
interface Errand<Services> {
  readonly services: Services;
  readonly signal?: Cancellation;
  readonly progress: NonNullable<EvaluateOptions['progress']>;
}

/**
 * Evaluates what nodes need and nothing else. A result is kept under the content that made it, so that an edit re-evaluates only what
 * depends on it, and an undo finds the old result again.
 */
export class Evaluator<Services> {
  readonly #registry: Registry<Services>;
  readonly #heavy: RunHeavy | undefined;
  readonly #results: Results;
  /** Work under way, by content. */
  readonly #pending = new Map<string, Pending<Services>>();
  #flat: { readonly of: GraphDocument; readonly graph: FlatGraph } | undefined;
  #latest: Latest<Services> | undefined;

  constructor(registry: Registry<Services>, { capacity = 16, heavy }: EvaluatorOptions = {}) {
    this.#registry = registry;
    this.#heavy = heavy;
    this.#results = new Results(capacity);
  }

  /** `targets`: a node, or several whose results stay in reach together; in groups by `outer/inner`. */
  async evaluate(
    document: GraphDocument,
    targets: string | readonly string[],
    services: Services,
    { signal, progress = () => {} }: EvaluateOptions = {},
  ): Promise<Evaluation> {
    const wanted = typeof targets === 'string' ? [targets] : targets;
    const [first = ''] = wanted;
    const flat = this.#flattened(document);
    if ('status' in flat) return { target: flat, results: new Map(wanted.map((id) => [id, flat])) };
    const asked = wanted.join(' ');
    const latest = this.#latest;
    if (latest?.flat === flat && latest.services === services && latest.asked === asked) return latest.evaluation;
    const errand = { services, signal, progress };
    const run = new Run(flat, this.#registry, (call: Call<Services>) => this.#perform(call, errand));
    const reached = run.reach(wanted);
    const results = await (signal ? Promise.race([reached, cancelling(signal)]) : reached);
    this.#results.trim(results.size);
    const target = results.get(first) ?? failure('graph.unknown-node', first, 'nothing was asked for');
    const evaluation = { target, results };
    this.#latest = [...results.values()].every(lasts) ? { flat, services, asked, evaluation } : undefined;
    return evaluation;
  }

  /** Where nodes stand, and notes, change nothing: then it is the same one as before. */
  #flattened(document: GraphDocument): FlatGraph | NodeResult {
    const { of, graph } = this.#flat ?? {};
    if (graph && of?.nodes === document.nodes && of.edges === document.edges && of.groups === document.groups)
      return graph;
    try {
      const flat = flatten(document, this.#registry);
      this.#flat = { of: document, graph: flat };
      return flat;
    } catch (error) {
      if (error instanceof DocumentError) return failure('graph.document', 'the project', error.message);
      throw error;
    }
  }

  #perform(call: Call<Services>, errand: Errand<Services>): NodeResult | Promise<NodeResult> {
    const content = this.#results.content(call.type.id, call.paramsKey, valuesOf(call));
    const known = this.#results.recall(content, call.id);
    if (known) return known;
    const pending = this.#pending.get(content);
    if (pending) return this.#join(pending, call, errand);
    if (errand.signal?.aborted) throw new CancelledError();
    const shared = new Shared(errand, call.id);
    const work = this.#start(call, errand.services, shared);
    if (!(work instanceof Promise)) return this.#finish(content, call.id, work);
    const result = work
      .then((outcome) => this.#finish(content, call.id, outcome))
      .finally(() => this.#pending.delete(content));
    this.#pending.set(content, { node: call.id, shared, result });
    return result;
  }

  /** Waits for the same work of another evaluation; where that was cancelled already, does it. */
  async #join(
    { node, shared, result }: Pending<Services>,
    call: Call<Services>,
    errand: Errand<Services>,
  ): Promise<NodeResult> {
    shared.join(errand, call.id);
    try {
      return at(await result, node, call.id);
    } catch (error) {
      if (!(error instanceof CancelledError) || errand.signal?.aborted) throw error;
      return this.#perform(call, errand);
    }
  }

  #start(call: Call<Services>, services: Services, shared: Shared<Services>): NodeResult | Promise<NodeResult> {
    const { id: node, type, inputs, params } = call;
    const { progress } = shared;
    const failed = (error: unknown): NodeResult => {
      if (shared.aborted || error instanceof CancelledError) throw new CancelledError();
      return { status: 'failed', problem: problemOf(error, node) };
    };
    const done = (outputs: Readonly<Record<string, unknown>>): NodeResult => ({ status: 'done', outputs });
    try {
      const outputs =
        type.heavy && this.#heavy
          ? this.#heavy({ type: type.id, node, inputs, params }, { signal: shared, progress })
          : type.evaluate(inputs, params, { services, signal: shared, progress, node });
      return outputs instanceof Promise ? outputs.then(done, failed) : done(outputs);
    } catch (error) {
      return failed(error);
    }
  }

  #finish(content: string, node: string, result: NodeResult): NodeResult {
    if (lasts(result)) this.#results.keep(content, node, result);
    return result;
  }
}

/** Work may go on for others after that. */
const cancelling = (signal: Cancellation): Promise<never> =>
  new Promise((_, reject) => signal.addEventListener('abort', () => reject(new CancelledError())));

/** Work under way, and the node that began it. */
interface Pending<Services> {
  readonly node: string;
  readonly shared: Shared<Services>;
  readonly result: Promise<NodeResult>;
}

/** Whom a piece of work is for: all evaluations that need it. It is cancelled when the last of them is, and all hear how far it is. */
class Shared<Services> implements Cancellation {
  readonly #errands: Errand<Services>[] = [];
  readonly #tell: Progress[] = [];
  readonly #listeners: (() => void)[] = [];
  #ended = false;

  constructor(errand: Errand<Services>, node: string) {
    this.join(errand, node);
  }

  get aborted(): boolean {
    return this.#ended || this.#errands.every(({ signal }) => signal?.aborted);
  }

  readonly progress: Progress = (part, what) => {
    for (const tell of this.#tell) tell(part, what);
  };

  join(errand: Errand<Services>, node: string): void {
    this.#errands.push(errand);
    this.#tell.push((part, what) => errand.progress(node, part, what));
    if (this.#listeners.length > 0) this.#watch(errand);
  }

  addEventListener(_: 'abort', listener: () => void): void {
    this.#listeners.push(listener);
    if (this.#listeners.length === 1) for (const errand of this.#errands) this.#watch(errand);
  }

  #watch({ signal }: Errand<Services>): void {
    signal?.addEventListener('abort', () => {
      if (this.#ended || !this.aborted) return;
      this.#ended = true;
      for (const listener of this.#listeners) listener();
    });
  }
}

/** The last evaluation, of which all would come out the same. */
interface Latest<Services> {
  readonly flat: FlatGraph;
  readonly services: Services;
  readonly asked: string;
  readonly evaluation: Evaluation;
}

/** What is neither done nor refused: a network that is down may be up the next time. */
const UNFORESEEN = 'graph.evaluation';
const lasts = (result: NodeResult): boolean => result.status !== 'failed' || result.problem.code !== UNFORESEEN;

/** Every value that flows in by itself: each of an input that takes many. */
const valuesOf = ({ type, inputs }: Call<never>): (readonly [string, unknown])[] =>
  Object.entries(inputs).flatMap(([name, value]) =>
    type.inputs[name]?.many && Array.isArray(value)
      ? value.map((item) => [name, item] as const)
      : [[name, value] as const],
  );

const problemOf = (error: unknown, node: string): Problem =>
  error instanceof NodeRefusal
    ? error.problem
    : {
        severity: 'error',
        code: UNFORESEEN,
        place: node,
        message: error instanceof Error ? error.message : String(error),
      };
