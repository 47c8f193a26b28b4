import { DocumentError, type GraphDocument } from './document.ts';
import { type FlatGraph, flatten } from './flatten.ts';
import { paced, Stopped } from './interim.ts';
import {
  type Cancellation,
  NodeRefusal,
  type Outputs,
  type Problem,
  type Progress,
  type Registry,
} from './nodeType.ts';
import { at, failure, type NodeResult, Results } from './results.ts';
import { type Call, Run } from './run.ts';
import { type Errand, Shared } from './shared.ts';

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
  /** Told whenever work that is waited for has given an interim. */
  readonly onInterim?: (node: string) => void;
  /**
   * Which interims are taken as if they were results. `stopped`: of work that was cancelled, which is then not begun again. `all`: also
   * of work that is under way, which this evaluation does not keep going. Without: none.
   */
  readonly interims?: 'stopped' | 'all';
}

/** A heavy node's work, in words that can be sent to another thread. */
export interface HeavyOrder {
  readonly type: string;
  readonly node: string;
  readonly inputs: Readonly<Record<string, unknown>>;
  readonly params: Call<never>['params'];
  /** It computes on a GPU. */
  readonly onGpu?: boolean;
  /** Whether interims are wanted. */
  readonly interims?: boolean;
  readonly resume?: Outputs;
}

/** Has heavy nodes evaluated elsewhere. */
export type RunHeavy = (
  order: HeavyOrder,
  work: { readonly signal?: Cancellation; readonly progress: Progress; readonly interim?: (outputs: Outputs) => void },
) => Promise<Outputs>;

export interface EvaluatorOptions {
  /** How many results are kept beside those of the latest evaluation, for an undo to find. */
  readonly capacity?: number;
  /** Without: heavy nodes are evaluated where all others are. */
  readonly heavy?: RunHeavy;
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
  readonly #stopped = new Stopped();
  /** What the latest evaluation made of interims. */
  #passing: ReadonlyMap<string, NodeResult> = new Map();
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
    { progress = () => {}, ...how }: EvaluateOptions = {},
  ): Promise<Evaluation> {
    const wanted = typeof targets === 'string' ? [targets] : targets;
    const [first = ''] = wanted;
    const flat = this.#flattened(document);
    if ('status' in flat) return { target: flat, results: new Map(wanted.map((id) => [id, flat])) };
    const asked = wanted.join(' ');
    const latest = this.#latest;
    if (latest?.flat === flat && latest.services === services && latest.asked === asked) return latest.evaluation;
    const { signal } = how;
    const errand: Errand<Services> = { ...how, services, progress, passing: new Map() };
    const run = new Run(flat, this.#registry, (call: Call<Services>) => this.#perform(call, errand));
    const reached = run.reach(wanted);
    const results = await (signal ? Promise.race([reached, cancelling(signal)]) : reached);
    this.#results.trim(results.size);
    this.#passing = errand.passing;
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
    const known = this.#results.recall(content, call.id) ?? this.#passed(content, errand);
    if (known) return known;
    const pending = this.#pending.get(content);
    if (pending && errand.interims === 'all') return soFar(pending, call.id);
    const stopped = this.#stopped.get(content);
    if (stopped && errand.interims) return interimOf(stopped);
    if (pending) return this.#join(pending, call, errand);
    if (errand.signal?.aborted) throw new CancelledError();
    const shared = new Shared(errand, call.id, stopped);
    const work = this.#start(call, errand, shared, stopped);
    if (!(work instanceof Promise)) return this.#finish(content, call, work, errand);
    const result = work
      .then(
        (outcome) => this.#finish(content, call, outcome, errand),
        (error) => {
          if (shared.interim) this.#stopped.keep(content, shared.interim);
          throw error;
        },
      )
      .finally(() => this.#pending.delete(content));
    this.#pending.set(content, { node: call.id, shared, result });
    return result;
  }

  /** What the evaluation before made of the same interims. */
  #passed(content: string, { passing }: Errand<Services>): NodeResult | undefined {
    const passed = this.#passing.get(content);
    if (passed) passing.set(content, passed);
    return passed;
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

  #start(
    { id: node, type, inputs, params }: Call<Services>,
    { services, onInterim }: Errand<Services>,
    shared: Shared<Services>,
    stopped: Outputs | undefined,
  ): NodeResult | Promise<NodeResult> {
    const { progress, give } = shared;
    const resume = stopped && { resume: stopped };
    const failed = (error: unknown): NodeResult => {
      if (shared.aborted || error instanceof CancelledError) throw new CancelledError();
      return { status: 'failed', problem: problemOf(error, node) };
    };
    const done = (outputs: Outputs): NodeResult => ({ status: 'done', outputs });
    try {
      const gpu = type.onGpu?.(params) && { onGpu: true };
      const order = { type: type.id, node, inputs, params, ...gpu, interims: onInterim !== undefined, ...resume };
      const interim = onInterim && { interim: paced(give) };
      const outputs =
        type.heavy && this.#heavy
          ? this.#heavy(order, { signal: shared, progress, interim: give })
          : type.evaluate(inputs, params, { services, signal: shared, progress, node, ...interim, ...resume });
      return outputs instanceof Promise ? outputs.then(done, failed) : done(outputs);
    } catch (error) {
      return failed(error);
    }
  }

  #finish(
    content: string,
    { id, interim }: Call<Services>,
    result: NodeResult,
    { passing }: Errand<Services>,
  ): NodeResult {
    this.#stopped.forget(content);
    if (!interim) {
      if (lasts(result)) this.#results.keep(content, id, result);
      return result;
    }
    const passed: NodeResult = result.status === 'done' ? { ...result, interim } : result;
    if (result.status === 'done') passing.set(content, passed);
    return passed;
  }
}

const interimOf = (outputs: Outputs): NodeResult => ({ status: 'done', outputs, interim: true });

/** What there is of work under way, as soon as there is something; of such as gives no interims, its result. */
async function soFar<Services>({ node, shared, result }: Pending<Services>, id: string): Promise<NodeResult> {
  await Promise.race([shared.begun, result]);
  return shared.interim ? interimOf(shared.interim) : at(await result, node, id);
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

/** The last evaluation, of which all would come out the same. */
interface Latest<Services> {
  readonly flat: FlatGraph;
  readonly services: Services;
  readonly asked: string;
  readonly evaluation: Evaluation;
}

/** What is neither done nor refused: a network that is down may be up the next time. And an interim is followed by another. */
const UNFORESEEN = 'graph.evaluation';
const lasts = (result: NodeResult): boolean =>
  result.status === 'failed' ? result.problem.code !== UNFORESEEN : result.status === 'blocked' || !result.interim;

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
