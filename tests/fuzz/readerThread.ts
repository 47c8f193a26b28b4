import { once } from 'node:events';
import { Worker } from 'node:worker_threads';
import type { Seed } from './seeds.ts';

/** Result of reading one file. */
export interface Outcome {
  /** The message of its InputError. */
  readonly refusal?: string;
  /** Code of the error, or codes of the scene's diagnostics. */
  readonly said?: string;
  /** Number of objects in the scene. */
  readonly objects?: number;
  /** A failure: another kind of error, an invalid scene, or a timeout. */
  readonly fault?: string;
  readonly milliseconds: number;
}

/** Maximum memory growth for a bomb, or for all mutations of one kind [bytes]. */
export const MEMORY_LIMIT = 2 ** 30;

/** Timeout of one read [ms]; the slowest valid file takes a tenth of a second on an idle machine. */
const READ_TIMEOUT = 20_000;

/** Reads files sequentially in a worker thread, which is restarted after a timeout. */
export class ReaderThread {
  private seed: Seed | undefined;
  private worker: Worker | undefined;

  /** Sends the seed's other files, unmodified. */
  async setSeed(seed: Seed): Promise<void> {
    this.seed = seed;
    const worker = this.worker ?? (await startWorker());
    worker.postMessage({ files: seed.files, entry: seed.entry });
    this.worker = worker;
  }

  async read(bytes: Uint8Array): Promise<Outcome> {
    const outcome = await this.answer(bytes);
    if (outcome) return outcome;
    await this.end();
    await this.setSeed(this.seed!);
    return { fault: 'it hangs, or ended the thread', milliseconds: READ_TIMEOUT };
  }

  /** Undefined on timeout. */
  private async answer(bytes: Uint8Array): Promise<Outcome | undefined> {
    const worker = this.worker!;
    const waiting = new AbortController();
    const timer = setTimeout(() => waiting.abort(), READ_TIMEOUT);
    try {
      worker.postMessage({ bytes });
      const [outcome] = await once(worker, 'message', { signal: waiting.signal });
      return outcome;
    } catch {
      return undefined;
    } finally {
      clearTimeout(timer);
    }
  }

  async end(): Promise<void> {
    await this.worker?.terminate();
    this.worker = undefined;
  }
}

/** Heap limit of the worker [MiB]; typed arrays do not count. */
const HEAP_LIMIT_MIB = 512;

async function startWorker(): Promise<Worker> {
  const library = new URL('../../dist/lib/formats/index.js', import.meta.url).href;
  const worker = new Worker(new URL('./readerWorker.mjs', import.meta.url), {
    workerData: { library },
    resourceLimits: { maxOldGenerationSizeMb: HEAP_LIMIT_MIB },
  });
  await once(worker, 'message');
  return worker;
}
