import type { StreamedPoints } from '../scene/streamedPoints.ts';
import { InputError } from '../scene/types.ts';
import type { PackedSamples } from './packedSamples.ts';
import type { SampleReply, SampleRequest } from './sampleServer.ts';

/** So many samples of one motion are on their way at a time: what is asked for and then not wanted any more costs little. */
const MOST_UNDER_WAY = 4;

export interface CourierNews {
  /** A sample has come, or room for asking for another one: pictures that wait for samples are to be tried again. */
  readonly onSamples?: (() => void) | undefined;
  /** Samples cannot be read any more; told once. */
  readonly onProblem?: ((error: Error) => void) | undefined;
}

/** Has samples of streamed motions read and packed by a worker (sampleServer.ts). */
export class SampleCourier {
  private readonly worker: Worker;
  private readonly news: CourierNews;
  private readonly motions: TravellingSamples[] = [];
  private failed = false;

  constructor(worker: Worker, news: CourierNews) {
    this.worker = worker;
    this.news = news;
    worker.onmessage = ({ data }: MessageEvent<SampleReply>) => this.receive(data);
    worker.onerror = (event) => this.fail(new Error(event.message || 'the worker that reads samples does not start'));
  }

  samplesOf(points: StreamedPoints): PackedSamples {
    const motion = this.motions.length;
    const ask = (k: number): void => {
      if (!this.failed) this.post({ kind: 'sample', motion, k });
    };
    const samples = new TravellingSamples(ask);
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
    this.news.onSamples?.();
  }

  private fail(error: Error): void {
    if (!this.failed) this.news.onProblem?.(error);
    this.failed = true;
  }

  private post(request: SampleRequest): void {
    this.worker.postMessage(request);
  }
}

class TravellingSamples implements PackedSamples {
  readonly travel = true;
  private readonly ask: (k: number) => void;
  private readonly underWay = new Set<number>();
  private readonly arrived = new Map<number, Float32Array<ArrayBuffer>>();
  private first = 0;
  private end = 0;

  constructor(ask: (k: number) => void) {
    this.ask = ask;
  }

  take(k: number): Float32Array<ArrayBuffer> | undefined {
    const rows = this.arrived.get(k);
    this.arrived.delete(k);
    if (!rows && !this.underWay.has(k) && this.underWay.size < MOST_UNDER_WAY) {
      this.underWay.add(k);
      this.ask(k);
    }
    return rows;
  }

  focus(first: number, end: number): void {
    this.first = first;
    this.end = end;
    for (const k of this.arrived.keys()) if (k < first || k >= end) this.arrived.delete(k);
  }

  receive(k: number, rows: Float32Array<ArrayBuffer>): void {
    this.underWay.delete(k);
    if (k >= this.first && k < this.end) this.arrived.set(k, rows);
  }
}
