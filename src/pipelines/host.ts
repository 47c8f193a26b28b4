import type { RendererOptions } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';

/** What pipelines need from where they run: the page, one of its workers, or Node. */
export interface PipelineHost {
  /** A GPU to draw pictures with, beside whatever else is drawn. Throws where there is none. */
  openGpu(): Promise<GpuAccess>;
  readonly threads: ThreadHost;
}

/** A GPU for as long as pictures are drawn with it. */
export interface GpuAccess {
  /** Its name, for reports. */
  readonly adapterName: string;
  /** Device or canvas, workers and callbacks. */
  readonly options: RendererOptions;
  /** Begins a new frame: three's passes are made once in each. */
  nextFrame(): Promise<unknown>;
  /** Compiles shaders between the viewport's frames. */
  readonly isShared: boolean;
  /** Rejects as soon as the device fails, whatever becomes of the work. */
  guard<T>(work: Promise<T>): Promise<T>;
  /** Throws what the GPU has reported since it was opened. */
  assertHealthy(): void;
  release(): void;
}

/** Threads to draw with on the processor. */
export interface ThreadHost {
  /** How many to start for a scene where nobody says. */
  count(scene: Scene): number;
  /** Memory that each of so many may fill with what can be computed again [bytes]. */
  cacheBytes(threads: number): number;
  /** Data that all threads get without a copy for each, where that can be. */
  share<T>(data: T): T;
  /** Starts a thread that runs `serveThread` of the pipeline with this id. */
  start<Message, Reply>(pipeline: string): WorkerThread<Message, Reply>;
  /** What went wrong in a thread, in words for people. */
  explain(error: Error, pipelineName: string): Error;
}

/** A thread, seen from outside. */
export interface WorkerThread<Message, Reply> {
  send(message: Message): void;
  /** What it answers, and what ends it; called once. */
  listen(hear: (reply: Reply) => void, fail: (error: Error) => void): void;
  terminate(): Promise<unknown> | undefined;
}

/** The thread's own end of the line. */
export interface ThreadPort {
  listen<Message>(hear: (message: Message) => void): void;
  /** `transfer`: memory that is handed over instead of copied. */
  post(reply: unknown, transfer: readonly ArrayBufferLike[]): void;
}
