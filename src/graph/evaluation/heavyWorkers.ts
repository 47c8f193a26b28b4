import type { Message } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { type NodeProblem, NodeRefusal, type Outputs, type Registry } from '../nodeType.ts';
import { CancelledError, type HeavyRequest, type RunHeavy } from './evaluator.ts';
import { throttleInterims } from './interim.ts';
import { transferables } from './transferables.ts';

/**
 * Heavy nodes in another thread: a Web Worker or a Node worker. Both ends are here; the message transport is passed in.
 * The same code runs there, so results are identical.
 */
type HeavyResponse =
  | { readonly kind: 'progress'; readonly part: number | undefined; readonly what: string | undefined }
  | { readonly kind: 'interim'; readonly outputs: Outputs }
  | { readonly kind: 'done'; readonly outputs: Outputs }
  /** With `problem` if the node refused its inputs; otherwise an unexpected error. */
  | { readonly kind: 'failed'; readonly message: Message; readonly problem?: NodeProblem };

/** The thread's end of the channel. */
export interface HeavyPort {
  listen(onReply: (order: HeavyRequest) => void): void;
  reply(reply: HeavyResponse, transfer: ArrayBuffer[]): void;
}

/** Serves heavy-node requests, one at a time. */
export function serveHeavy<Services>(registry: Registry<Services>, services: Services, port: HeavyPort): void {
  port.listen(async ({ type, node, inputs, params, interims, resume }) => {
    const progress = (part: number | undefined, what?: string): void =>
      port.reply({ kind: 'progress', part, what }, []);
    // Copied, since the work continues with the original.
    const interim = interims && {
      interim: throttleInterims((outputs) => port.reply({ kind: 'interim', outputs }, [])),
    };
    const work = { services, progress, node, ...interim, ...(resume && { resume }) };
    try {
      const outputs = await registry[type]!.evaluate(inputs, params, work);
      port.reply({ kind: 'done', outputs }, transferables(outputs));
    } catch (error) {
      port.reply(
        { kind: 'failed', message: messageOf(error), ...(error instanceof NodeRefusal && { problem: error.problem }) },
        [],
      );
    }
  });
}

/** The caller's end of a serving thread. */
export interface HeavyWorker {
  send(order: HeavyRequest): void;
  /** Registers the handlers of messages and of failure; called once. */
  listen(onReply: (reply: HeavyResponse) => void, fail: (error: Error) => void): void;
  end(): void;
}

/** A reusable thread, and its current request. */
interface PooledWorker {
  readonly thread: HeavyWorker;
  hear: (reply: HeavyResponse) => void;
  fail: (error: Error) => void;
}

/** Runs heavy nodes in a pool of threads, one node each; cancelling terminates the thread. */
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
        else reject(reply.problem ? new NodeRefusal(reply.problem) : new MessageError(reply.message));
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
