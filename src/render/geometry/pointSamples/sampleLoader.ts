import type { StreamedPoints } from '../../../scene/streaming/storedPoints.ts';
import { InputError } from '../../../scene/types.ts';
import type { PackedSamples } from './packedSamples.ts';
import type { SampleReply, SampleRequest } from './sampleServer.ts';

/** So many samples of one motion are on their way at a time: what is asked for and then not wanted any more costs little. */
const MAX_IN_FLIGHT = 4;

export interface SampleLoaderCallbacks {
  /** A sample has come, or room for asking for another one: pictures that wait for samples are to be tried again. */
  readonly onSamples?: (() => void) | undefined;
  /** Samples cannot be read any more; told once. */
  readonly onError?: ((error: Error) => void) | undefined;
}

/** Has samples of streamed motions read and packed by a worker (sampleServer.ts). */
export class SampleLoader {
  private readonly worker: Worker;
  private readonly callbacks: SampleLoaderCallbacks;
  private readonly motions: WorkerSamples[] = [];
  private failed = false;

  constructor(worker: Worker, news: SampleLoaderCallbacks) {
    this.worker = worker;
    this.callbacks = news;
    worker.onmessage = ({ data }: MessageEvent<SampleReply>) => this.receive(data);
    worker.onerror = (event) => this.fail(new Error(event.message || 'the worker that reads samples does not start'));
  }

  samplesOf(points: StreamedPoints): PackedSamples {
    const motion = this.motions.length;
    const ask = (k: number): void => {
      if (!this.failed) this.post({ kind: 'sample', motion, k });
    };
    const samples = new WorkerSamples(ask);
    this.motions.push(samples);
    this.post({ kind: 'motion', motion, points });
    return samples;
  }

  dispose(): void {
    this.worker.terminate();
  }

  private receive({ motion, k, rows, failed }: SampleReply): void {
    if (failed) this.fail(failed.diagnostic ? new InputError(failed.diagnostic) : new Error(failed.message));
    else if (rows) this.motions[motion].receive(k, rows);
    this.callbacks.onSamples?.();
  }

  private fail(error: Error): void {
    if (!this.failed) this.callbacks.onError?.(error);
    this.failed = true;
  }

  private post(request: SampleRequest): void {
    this.worker.postMessage(request);
  }
}

class WorkerSamples implements PackedSamples {
  readonly isAsync = true;
  private readonly request: (k: number) => void;
  private readonly inFlight = new Set<number>();
  private readonly loaded = new Map<number, Float32Array<ArrayBuffer>>();
  private first = 0;
  private end = 0;

  constructor(ask: (k: number) => void) {
    this.request = ask;
  }

  take(k: number): Float32Array<ArrayBuffer> | undefined {
    const rows = this.loaded.get(k);
    this.loaded.delete(k);
    if (!rows && !this.inFlight.has(k) && this.inFlight.size < MAX_IN_FLIGHT) {
      this.inFlight.add(k);
      this.request(k);
    }
    return rows;
  }

  setWindow(first: number, end: number): void {
    this.first = first;
    this.end = end;
    for (const k of this.loaded.keys()) if (k < first || k >= end) this.loaded.delete(k);
  }

  receive(k: number, rows: Float32Array<ArrayBuffer>): void {
    this.inFlight.delete(k);
    if (k >= this.first && k < this.end) this.loaded.set(k, rows);
  }
}
