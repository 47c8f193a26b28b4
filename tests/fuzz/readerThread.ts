import { once } from 'node:events';
import { Worker } from 'node:worker_threads';
import type { Seed } from './seeds.ts';

/** How the reading of one file ended. */
export interface Outcome {
  /** The message of its InputError. */
  readonly refusal?: string;
  /** The codes of that, or of what is said of the scene. */
  readonly said?: string;
  /** Of the scene that it makes. */
  readonly objects?: number;
  /** What must not be: an error of another kind, a scene that is not sound, a reader that hangs. */
  readonly fault?: string;
  readonly milliseconds: number;
}

/** Memory that a bomb, or the readings of all damaged files of a kind, may take beyond what there was before [bytes]. */
export const MEMORY_LIMIT = 2 ** 30;

/** A reading that takes longer hangs [ms]. The slowest of honest ones takes a tenth of a second on a quiet machine. */
const READ_TIMEOUT = 20_000;

/** Reads files one after another in a thread, which is ended and begun anew where one hangs. */
export class ReaderThread {
  private seed: Seed | undefined;
  private worker: Worker | undefined;

  /** Takes the seed's other files as they are. */
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

  /** Undefined where none comes. */
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

/** Heap that a reader may use [MiB]; typed arrays are outside it. */
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
