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
  /** Work under way: a second evaluation that needs the same content waits for the first one's. */
  readonly #pending = new Map<string, { readonly node: string; readonly result: Promise<NodeResult> }>();
  readonly #flat = new WeakMap<GraphDocument, FlatGraph>();

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
    const errand = { services, signal, progress };
    const run = new Run(flat, this.#registry, (call: Call<Services>) => this.#perform(call, errand));
    const results = await run.reach(wanted);
    this.#results.trim(results.size);
    return { target: results.get(first) ?? failure('graph.unknown-node', first, 'nothing was asked for'), results };
  }

  #flattened(document: GraphDocument): FlatGraph | NodeResult {
    const known = this.#flat.get(document);
    if (known) return known;
    try {
      const flat = flatten(document, this.#registry);
      this.#flat.set(document, flat);
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
    const work = this.#start(call, errand);
    if (!(work instanceof Promise)) return this.#finish(content, call.id, work);
    const result = work
      .then((outcome) => this.#finish(content, call.id, outcome))
      .finally(() => this.#pending.delete(content));
    this.#pending.set(content, { node: call.id, result });
    return result;
  }

  /** Waits for the same work of another evaluation; where that is cancelled, does it. */
  async #join(
    { node, result }: { readonly node: string; readonly result: Promise<NodeResult> },
    call: Call<Services>,
    errand: Errand<Services>,
  ): Promise<NodeResult> {
    try {
      return at(await result, node, call.id);
    } catch (error) {
      if (!(error instanceof CancelledError) || errand.signal?.aborted) throw error;
      return this.#perform(call, errand);
    }
  }

  #start(call: Call<Services>, errand: Errand<Services>): Outcome | Promise<Outcome> {
    const { id: node, type, inputs, params } = call;
    const progress: Progress = (part, what) => errand.progress(node, part, what);
    const { services, signal } = errand;
    const failed = (error: unknown): Outcome => {
      if (signal?.aborted || error instanceof CancelledError) throw new CancelledError();
      // A refusal follows from the content; anything else (a network that is down) may go better next time.
      return { result: { status: 'failed', problem: problemOf(error, node) }, lasts: error instanceof NodeRefusal };
    };
    const done = (outputs: Readonly<Record<string, unknown>>): Outcome => ({
      result: { status: 'done', outputs },
      lasts: true,
    });
    try {
      const outputs =
        type.heavy && this.#heavy
          ? this.#heavy({ type: type.id, node, inputs, params }, { signal, progress })
          : type.evaluate(inputs, params, { services, signal, progress, node });
      return outputs instanceof Promise ? outputs.then(done, failed) : done(outputs);
    } catch (error) {
      return failed(error);
    }
  }

  #finish(content: string, node: string, { result, lasts }: Outcome): NodeResult {
    if (lasts) this.#results.keep(content, node, result);
    return result;
  }
}

interface Outcome {
  readonly result: NodeResult;
  /** Whether the same content will give it again. */
  readonly lasts: boolean;
}

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
        code: 'graph.evaluation',
        place: node,
        message: error instanceof Error ? error.message : String(error),
      };
