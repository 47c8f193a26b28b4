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
  /** A failure: another kind of error, an invalid scene, or a read without end. */
  readonly fault?: string;
  readonly milliseconds: number;
}

/** Maximum memory growth for a bomb, or for all mutations of one kind [bytes]. */
export const MEMORY_LIMIT = 2 ** 30;

/** Processor time of one read, beyond which it hangs [ms]; the slowest valid file takes a tenth of a second. */
const READ_LIMIT = 20_000;
/** How often that is looked at [ms]. */
const LOOK_INTERVAL = 100;

/** Reads files sequentially in a worker thread, which is restarted if it hangs. */
export class ReaderThread {
  private seed: Seed | undefined;
  private worker: Worker | undefined;

  /** Sends the seed's other files, unmodified. */
  async setSeed(seed: Seed): Promise<void> {
    this.seed = seed;
    const worker = this.worker ?? (await startWorker());
    worker.postMessage({ files: seed.files, entry: seed.entry, opened: seed.opened ?? seed.entry });
    this.worker = worker;
  }

  async read(bytes: Uint8Array): Promise<Outcome> {
    const outcome = await this.answer(bytes);
    if (outcome) return outcome;
    await this.end();
    await this.setSeed(this.seed!);
    return { fault: 'it hangs, or ended the thread', milliseconds: READ_LIMIT };
  }

  /** Undefined if it hangs: other processes do not count. */
  private async answer(bytes: Uint8Array): Promise<Outcome | undefined> {
    const worker = this.worker!;
    const waiting = new AbortController();
    const before = process.cpuUsage();
    const timer = setInterval(() => {
      const { user, system } = process.cpuUsage(before);
      if ((user + system) / 1000 > READ_LIMIT) waiting.abort();
    }, LOOK_INTERVAL);
    try {
      worker.postMessage({ bytes });
      const [outcome] = await once(worker, 'message', { signal: waiting.signal });
      return outcome;
    } catch {
      return undefined;
    } finally {
      clearInterval(timer);
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
  const library = new URL('../../dist/lib/', import.meta.url).href;
  const worker = new Worker(new URL('./readerWorker.mjs', import.meta.url), {
    workerData: { library },
    resourceLimits: { maxOldGenerationSizeMb: HEAP_LIMIT_MIB },
  });
  await once(worker, 'message');
  return worker;
}
