import type { LocalizedText } from '../messages/message.ts';
import type { RendererOptions } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { OpenFilmReader } from './films/filmReader.ts';

/** Services of a pipeline's environment: the page, one of its workers, or Node. */
export interface PipelineHost {
  /** Opens a GPU for pictures; it may be shared with other renderers. Throws if there is none. */
  openGpu(): Promise<GpuAccess>;
  readonly threads: ThreadHost;
  /** Opens a film; it is decoded by the environment. */
  readonly openFilm: OpenFilmReader;
}

/** A GPU, until `release`. */
export interface GpuAccess {
  /** Its name, for reports. */
  readonly adapterName: string;
  /** Device or canvas, workers and callbacks. */
  readonly options: RendererOptions;
  /** Begins a new frame; three renders its passes once per frame. */
  nextFrame(): Promise<unknown>;
  /** Whether the viewport uses the same GPU; shaders are then compiled between its frames. */
  readonly isShared: boolean;
  /** Returns the work's promise, rejected as soon as the device fails. */
  guard<T>(work: Promise<T>): Promise<T>;
  /** Throws the first error that the GPU has reported since it was opened. */
  assertHealthy(): void;
  release(): void;
}

/** Worker threads of the environment. */
export interface ThreadHost {
  /** Default number of threads for a scene. */
  count(scene: Scene): number;
  /** Cache memory per thread [bytes]. */
  cacheBytes(threads: number): number;
  /** The data in shared memory, if the environment supports it. */
  share<T>(data: T): T;
  /** Starts a thread that runs `serveThread` of the pipeline with this id. */
  start<Message, Reply>(pipeline: string): WorkerThread<Message, Reply>;
  /** A thread's error with a message for users. */
  explain(error: Error, pipelineName: LocalizedText): Error;
}

/** A worker thread, from the main thread. */
export interface WorkerThread<Message, Reply> {
  send(message: Message): void;
  /** Sets the listeners for replies and errors; called once. */
  listen(onReply: (reply: Reply) => void, onError: (error: Error) => void): void;
  terminate(): Promise<unknown> | undefined;
}

/** The thread's side of the connection. */
export interface ThreadPort {
  listen<Message>(onMessage: (message: Message) => void): void;
  /** `transfer`: buffers that are transferred instead of copied. */
  post(reply: unknown, transfer: readonly ArrayBufferLike[]): void;
}
