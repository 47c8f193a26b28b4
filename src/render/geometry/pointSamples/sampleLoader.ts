import type { StreamedPoints } from '../../../scene/streaming/storedPoints.ts';
import { InputError } from '../../../scene/types.ts';
import type { PackedSamples } from './packedSamples.ts';
import type { SampleReply, SampleRequest } from './sampleServer.ts';

/** Samples of one motion that are requested at a time; few, so that little is wasted if they are not needed any more. */
const MAX_IN_FLIGHT = 4;

export interface SampleLoaderCallbacks {
  /** A sample has arrived, or another one can be requested: frames that wait for samples should be drawn again. */
  readonly onSamples?: (() => void) | undefined;
  /** Samples cannot be read any more; called once. */
  readonly onError?: ((error: Error) => void) | undefined;
}

/** Has samples of streamed motions read and packed by a worker (sampleServer.ts). */
export class SampleLoader {
  private readonly worker: Worker;
  private readonly callbacks: SampleLoaderCallbacks;
  private readonly motions: WorkerSamples[] = [];
  private failed = false;

  constructor(worker: Worker, callbacks: SampleLoaderCallbacks) {
    this.worker = worker;
    this.callbacks = callbacks;
    worker.onmessage = ({ data }: MessageEvent<SampleReply>) => this.receive(data);
    worker.onerror = (event) => this.fail(new Error(event.message || 'the worker that reads samples does not start'));
  }

  samplesOf(points: StreamedPoints): PackedSamples {
    const motion = this.motions.length;
    const request = (k: number): void => {
      if (!this.failed) this.post({ kind: 'sample', motion, k });
    };
    const samples = new WorkerSamples(request);
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

  constructor(request: (k: number) => void) {
    this.request = request;
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
