import { type NodeProblem, NodeRefusal, type Outputs, type Registry } from '../nodeType.ts';
import { CancelledError, type HeavyRequest, type RunHeavy } from './evaluator.ts';
import { throttleInterims } from './interim.ts';
import { transferables } from './transferables.ts';

/**
 * Heavy nodes in another thread: a worker of a page, or one of Node's. Both ends are here; what carries the messages is given. The same
 * code computes there, so the result is the same.
 */
type HeavyResponse =
  | { readonly kind: 'progress'; readonly part: number | undefined; readonly what: string | undefined }
  | { readonly kind: 'interim'; readonly outputs: Outputs }
  | { readonly kind: 'done'; readonly outputs: Outputs }
  /** `problem` where the node refused its inputs; else something unforeseen. */
  | { readonly kind: 'failed'; readonly message: string; readonly problem?: NodeProblem };

/** The thread's own end. */
export interface HeavyPort {
  listen(hear: (order: HeavyRequest) => void): void;
  reply(reply: HeavyResponse, transfer: ArrayBuffer[]): void;
}

/** Evaluates what it is told to, one order at a time. */
export function serveHeavy<Services>(registry: Registry<Services>, services: Services, port: HeavyPort): void {
  port.listen(async ({ type, node, inputs, params, interims, resume }) => {
    const progress = (part: number | undefined, what?: string): void =>
      port.reply({ kind: 'progress', part, what }, []);
    // It is copied: the work goes on with what it is made of.
    const interim = interims && {
      interim: throttleInterims((outputs) => port.reply({ kind: 'interim', outputs }, [])),
    };
    const work = { services, progress, node, ...interim, ...(resume && { resume }) };
    try {
      const outputs = await registry[type]!.evaluate(inputs, params, work);
      port.reply({ kind: 'done', outputs }, transferables(outputs));
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      port.reply({ kind: 'failed', message, ...(error instanceof NodeRefusal && { problem: error.problem }) }, []);
    }
  });
}

/** A thread that serves, seen from outside. */
export interface HeavyWorker {
  send(order: HeavyRequest): void;
  /** What it says, and what ends it; called once. */
  listen(hear: (reply: HeavyResponse) => void, fail: (error: Error) => void): void;
  end(): void;
}

/** A thread that is kept for the next order, and the order that it has. */
interface PooledWorker {
  readonly thread: HeavyWorker;
  hear: (reply: HeavyResponse) => void;
  fail: (error: Error) => void;
}

/** Has heavy nodes evaluated by threads, one for each at a time; to cancel is to end the thread, whatever it is doing. */
export function heavyWorkerPool(start: () => HeavyWorker): RunHeavy {
  const idle: PooledWorker[] = [];
  return (order, { signal, progress, interim }) => {
    if (signal?.aborted) return Promise.reject(new CancelledError());
    const worker = idle.pop() ?? startWorker(start);
    const end = (): void => worker.thread.end();
    return new Promise((resolve, reject) => {
      const fail = (error: Error): void => {
        end();
        reject(error);
      };
      worker.fail = fail;
      worker.hear = (reply) => {
        if (reply.kind === 'progress') {
          progress(reply.part, reply.what);
          return;
        }
        if (reply.kind === 'interim') {
          interim?.(reply.outputs);
          return;
        }
        idle.push(worker);
        worker.fail = () => void idle.splice(idle.indexOf(worker), 1);
        if (reply.kind === 'done') resolve(reply.outputs);
        else reject(reply.problem ? new NodeRefusal(reply.problem) : new Error(reply.message));
      };
      signal?.addEventListener('abort', () => {
        if (!idle.includes(worker)) fail(new CancelledError());
      });
      try {
        worker.thread.send(order);
      } catch (error) {
        fail(error instanceof Error ? error : new Error(String(error)));
      }
    });
  };
}

function startWorker(start: () => HeavyWorker): PooledWorker {
  const worker: PooledWorker = { thread: start(), hear: () => {}, fail: () => {} };
  worker.thread.listen(
    (reply) => worker.hear(reply),
    (error) => worker.fail(error),
  );
  return worker;
}
