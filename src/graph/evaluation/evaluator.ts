import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { type FlatGraph, flatten } from '../analysis/flatten.ts';
import { DocumentError, type GraphDocument } from '../document/document.ts';
import {
  type AbortSignalLike,
  type NodeProblem,
  NodeRefusal,
  type Outputs,
  type ProgressCallback,
  type Registry,
} from '../nodeType.ts';
import { InterimCache, throttleInterims } from './interim.ts';
import { failure, type NodeResult, ResultCache, resultAtNode } from './resultCache.ts';
import { type NodeCall, Scheduler } from './scheduler.ts';
import { type EvaluationJob, SharedWork } from './sharedWork.ts';

/** What an evaluation found. */
export interface Evaluation {
  /** Result of the first target. */
  readonly target: NodeResult;
  /** Results of all nodes that the targets need; in groups `outer/inner`. */
  readonly results: ReadonlyMap<string, NodeResult>;
}

/**
 * Thrown when an evaluation is cancelled.
 * @example
 * import { msg } from 'slowlight/messages';
 * const wait: NodeType = {
 *   id: 'wait',
 *   title: msg`Wait`,
 *   help: msg`Never ready.`,
 *   category: 'utility',
 *   params: {},
 *   inputs: {},
 *   outputs: {},
 *   evaluate: () => new Promise(() => {}),
 * };
 * const { document } = applyCommand(emptyDocument(), { kind: 'add-node', node: 'w', type: 'wait', at: [0, 0] });
 * const stop = new AbortController();
 * const running = new Evaluator({ wait }).evaluate(document, 'w', {}, { signal: stop.signal });
 * stop.abort();
 * const error = await running.catch((reason) => reason);
 * error instanceof CancelledError; // true
 */
export class CancelledError extends Error {
  constructor() {
    super('cancelled');
    this.name = 'CancelledError';
  }
}

/** How an evaluation is watched and cancelled. */
export interface EvaluateOptions {
  /** Cancels the evaluation, which then throws a CancelledError. */
  readonly signal?: AbortSignalLike;
  /** Told how far the work of a node is. */
  readonly progress?: (node: string, ...report: Parameters<ProgressCallback>) => void;
  /** Called when running work that is waited for has an interim result. */
  readonly onInterim?: (node: string) => void;
  /**
   * Which interim results are used as if final. `stopped`: those of cancelled work, which is then not restarted. `all`:
   * also those of running work, which this evaluation does not keep alive. Default: none.
   */
  readonly interims?: 'stopped' | 'all';
}

/** Work of a heavy node as a message to another thread. */
export interface HeavyRequest {
  /** Of the node. */
  readonly type: string;
  /** Its id, for messages. */
  readonly node: string;
  /** By socket. */
  readonly inputs: Readonly<Record<string, unknown>>;
  /** All parameters. */
  readonly params: NodeCall<never>['params'];
  /** Whether it computes on a GPU. */
  readonly onGpu?: boolean;
  /** Whether interim results are requested. */
  readonly interims?: boolean;
  /** The last interim result of the same content. */
  readonly resume?: Outputs;
}

/** Runs heavy nodes elsewhere. */
export type RunHeavy = (
  order: HeavyRequest,
  work: {
    readonly signal?: AbortSignalLike;
    readonly progress: ProgressCallback;
    readonly interim?: (outputs: Outputs) => void;
  },
) => Promise<Outputs>;

/** What an evaluator keeps, and where it works. */
export interface EvaluatorOptions {
  /** Number of results cached beyond those of the latest evaluation, for undo. */
  readonly capacity?: number;
  /** Default: heavy nodes run in the same thread as others. */
  readonly heavy?: RunHeavy;
}

/**
 * Evaluates only what the targets need. Results are cached under the content that made them, so an edit re-evaluates
 * only what depends on it, and an undo finds the previous results.
 * @example
 * import { msg } from 'slowlight/messages';
 * const double: NodeType = {
 *   id: 'double',
 *   title: msg`Double`,
 *   help: msg`Twice a number.`,
 *   category: 'utility',
 *   params: { value: { kind: 'number', title: 'Value', default: 1, min: 0, max: 100, step: 1 } },
 *   inputs: {},
 *   outputs: { number: { type: 'number' } },
 *   evaluate: (_, { value }) => ({ number: 2 * Number(value) }),
 * };
 * const { document } = applyCommand(emptyDocument(), { kind: 'add-node', node: 'd', type: 'double', at: [0, 0] });
 * const { target } = await new Evaluator({ double }).evaluate(document, 'd', {});
 * target; // { status: 'done', outputs: { number: 2 } }
 */
export class Evaluator<Services> {
  private readonly registry: Registry<Services>;
  private readonly heavy: RunHeavy | undefined;
  private readonly results: ResultCache;
  /** Running work, by content. */
  private readonly pending = new Map<string, PendingWork<Services>>();
  private readonly stopped = new InterimCache();
  /** Results of the latest evaluation that depend on interim results. */
  private lastInterimResults: ReadonlyMap<string, NodeResult> = new Map();
  private flat: { readonly of: GraphDocument; readonly graph: FlatGraph } | undefined;
  private latest: LastEvaluation<Services> | undefined;

  constructor(registry: Registry<Services>, { capacity = 16, heavy }: EvaluatorOptions = {}) {
    this.registry = registry;
    this.heavy = heavy;
    this.results = new ResultCache(capacity);
  }

  /** `targets`: a node, or several whose results stay cached together; in groups `outer/inner`. */
  async evaluate(
    document: GraphDocument,
    targets: string | readonly string[],
    services: Services,
    { progress = () => {}, ...how }: EvaluateOptions = {},
  ): Promise<Evaluation> {
    const wanted = typeof targets === 'string' ? [targets] : targets;
    const [first = ''] = wanted;
    const flat = this.flattened(document);
    if ('status' in flat) return { target: flat, results: new Map(wanted.map((id) => [id, flat])) };
    const targetsKey = wanted.join(' ');
    const latest = this.latest;
    if (latest?.flat === flat && latest.services === services && latest.targetsKey === targetsKey)
      return latest.evaluation;
    const { signal } = how;
    const job: EvaluationJob<Services> = { ...how, services, progress, interimResults: new Map() };
    const run = new Scheduler(flat, this.registry, (call: NodeCall<Services>) => this.perform(call, job));
    const reached = run.run(wanted);
    const results = await (signal ? Promise.race([reached, rejectOnAbort(signal)]) : reached);
    this.results.trim(results.size);
    this.lastInterimResults = job.interimResults;
    const target = results.get(first) ?? failure('graph.unknown-node', first, msg`nothing was asked for`);
    const evaluation = { target, results };
    this.latest = [...results.values()].every(isCacheable) ? { flat, services, targetsKey, evaluation } : undefined;
    return evaluation;
  }

  /** Cached while only positions and notes change. */
  private flattened(document: GraphDocument): FlatGraph | NodeResult {
    const { of, graph } = this.flat ?? {};
    if (graph && of?.nodes === document.nodes && of.edges === document.edges && of.groups === document.groups)
      return graph;
    try {
      const flat = flatten(document, this.registry);
      this.flat = { of: document, graph: flat };
      return flat;
    } catch (error) {
      if (error instanceof DocumentError) return failure('graph.document', msg`the project`, error.text);
      throw error;
    }
  }

  private perform(call: NodeCall<Services>, job: EvaluationJob<Services>): NodeResult | Promise<NodeResult> {
    const content = this.results.keyOf(call.type.id, call.paramsKey, inputValues(call));
    const known = this.results.get(content, call.id) ?? this.reusedInterim(content, job);
    if (known) return known;
    const pending = this.pending.get(content);
    if (pending && job.interims === 'all') return firstInterimOf(pending, call.id);
    const stopped = this.stopped.get(content);
    if (stopped && job.interims) return interimResult(stopped);
    if (pending) return this.join(pending, call, job);
    if (job.signal?.aborted) throw new CancelledError();
    const shared = new SharedWork(job, call.id, stopped);
    const work = this.start(call, job, shared, stopped);
    if (!(work instanceof Promise)) return this.finish(content, call, work, job);
    const result = work
      .then(
        (settled) => this.finish(content, call, settled, job),
        (error) => {
          if (shared.interim) this.stopped.set(content, shared.interim);
          throw error;
        },
      )
      .finally(() => this.pending.delete(content));
    this.pending.set(content, { node: call.id, shared, result });
    return result;
  }

  /** What the previous evaluation made of the same interim results. */
  private reusedInterim(content: string, { interimResults }: EvaluationJob<Services>): NodeResult | undefined {
    const reusedResult = this.lastInterimResults.get(content);
    if (reusedResult) interimResults.set(content, reusedResult);
    return reusedResult;
  }

  /** Waits for the same work of another evaluation; if that was cancelled, performs it. */
  private async join(
    { node, shared, result }: PendingWork<Services>,
    call: NodeCall<Services>,
    job: EvaluationJob<Services>,
  ): Promise<NodeResult> {
    shared.join(job, call.id);
    try {
      return resultAtNode(await result, node, call.id);
    } catch (error) {
      if (!(error instanceof CancelledError) || job.signal?.aborted) throw error;
      return this.perform(call, job);
    }
  }

  private start(
    { id: node, type, inputs, params }: NodeCall<Services>,
    { services, onInterim }: EvaluationJob<Services>,
    shared: SharedWork<Services>,
    stopped: Outputs | undefined,
  ): NodeResult | Promise<NodeResult> {
    const { progress, reportInterim } = shared;
    const resume = stopped && { resume: stopped };
    const failed = (error: unknown): NodeResult => {
      if (shared.aborted || error instanceof CancelledError) throw new CancelledError();
      return { status: 'failed', problem: toProblem(error, node) };
    };
    const done = (outputs: Outputs): NodeResult => ({ status: 'done', outputs });
    try {
      const gpu = type.onGpu?.(params) && { onGpu: true };
      const order = { type: type.id, node, inputs, params, ...gpu, interims: onInterim !== undefined, ...resume };
      const interim = onInterim && { interim: throttleInterims(reportInterim) };
      const outputs =
        type.heavy && this.heavy
          ? this.heavy(order, { signal: shared, progress, interim: reportInterim })
          : type.evaluate(inputs, params, { services, signal: shared, progress, node, ...interim, ...resume });
      return outputs instanceof Promise ? outputs.then(done, failed) : done(outputs);
    } catch (error) {
      return failed(error);
    }
  }

  private finish(
    content: string,
    { id, interim }: NodeCall<Services>,
    result: NodeResult,
    { interimResults }: EvaluationJob<Services>,
  ): NodeResult {
    this.stopped.delete(content);
    if (!interim) {
      if (isCacheable(result)) this.results.set(content, id, result);
      return result;
    }
    const reusedResult: NodeResult = result.status === 'done' ? { ...result, interim } : result;
    if (result.status === 'done') interimResults.set(content, reusedResult);
    return reusedResult;
  }
}

const interimResult = (outputs: Outputs): NodeResult => ({ status: 'done', outputs, interim: true });

/** First interim result of running work; its final result if it has no interim results. */
async function firstInterimOf<Services>(
  { node, shared, result }: PendingWork<Services>,
  id: string,
): Promise<NodeResult> {
  await Promise.race([shared.firstInterim, result]);
  return shared.interim ? interimResult(shared.interim) : resultAtNode(await result, node, id);
}

/** The work may continue for other evaluations. */
const rejectOnAbort = (signal: AbortSignalLike): Promise<never> =>
  new Promise((_, reject) => signal.addEventListener('abort', () => reject(new CancelledError())));

/** Running work, and the node that started it. */
interface PendingWork<Services> {
  readonly node: string;
  readonly shared: SharedWork<Services>;
  readonly result: Promise<NodeResult>;
}

/** The last evaluation, which is reused if nothing changed. */
interface LastEvaluation<Services> {
  readonly flat: FlatGraph;
  readonly services: Services;
  readonly targetsKey: string;
  readonly evaluation: Evaluation;
}

/**
 * Neither result nor refusal, and not cached: a network error may be gone the next time. Interim results are not cached
 * either.
 */
const UNEXPECTED_ERROR = 'graph.evaluation';
const isCacheable = (result: NodeResult): boolean =>
  result.status === 'failed'
    ? result.problem.code !== UNEXPECTED_ERROR
    : result.status === 'blocked' || !result.interim;

/** All input values, with those of multi-edge inputs listed separately. */
const inputValues = ({ type, inputs }: NodeCall<never>): (readonly [string, unknown])[] =>
  Object.entries(inputs).flatMap(([name, value]) =>
    type.inputs[name]?.many && Array.isArray(value)
      ? value.map((item) => [name, item] as const)
      : [[name, value] as const],
  );

const toProblem = (error: unknown, node: string): NodeProblem =>
  error instanceof NodeRefusal
    ? error.problem
    : {
        severity: 'error',
        code: UNEXPECTED_ERROR,
        place: node,
        message: messageOf(error),
      };
