import type { DomePicture } from '../scene/types.ts';
import type { NoisyTile } from './denoise/noisyTile.ts';
import { squaresOfPicture } from './squares.ts';
import { channelsOf } from './tile.ts';
import type { ImageTile, OutputLayer, TileData, TileRequest } from './tileRequest.ts';
import type { TracerMessage, TracerReply } from './tracerServer.ts';

/** A thread that runs `serveTracer`, as seen by the pool. */
export interface TracerThread {
  send(message: TracerMessage): void;
  /** Sets the callbacks for replies and for the error that ends the thread; called once. */
  listen(hear: (reply: TracerReply) => void, fail: (error: Error) => void): void;
  terminate(): Promise<unknown> | undefined;
}

/** What a thread does at a time. */
type TileOrder = Extract<TracerMessage, { readonly kind: 'tile' | 'denoise' }>;

/** A picture being rendered or denoised: the remaining tiles, and callbacks. */
interface PictureJob {
  readonly orders: TileOrder[];
  left: number;
  readonly onTile: (tile: ImageTile, data: TileData) => void;
  readonly done: () => void;
  readonly fail: (error: Error) => void;
}

/**
 * Threads that render the tiles of one scene's pictures. Each takes the next tile when it has finished one; a tile's bits do not depend on the
 * thread. Any error in a thread rejects the picture and terminates all threads.
 */
export class TracerPool {
  private readonly threads: readonly TracerThread[];
  private readonly explain: (error: Error) => Error;
  private job: PictureJob | undefined;
  private failure: Error | undefined;

  /** `explain` turns a thread's error into one with a message for users. */
  constructor(
    threads: readonly TracerThread[],
    scene: Extract<TracerMessage, { readonly kind: 'scene' }>,
    explain: (error: Error) => Error = (error) => error,
  ) {
    this.threads = threads;
    this.explain = explain;
    for (const thread of threads) {
      thread.listen(
        (reply) => this.onReply(thread, reply),
        (error) => this.stop(explain(error)),
      );
      thread.send(scene);
    }
  }

  /** Shows another picture of the scene's dome, from the next picture on. */
  showDome(picture: DomePicture): void {
    for (const thread of this.threads) thread.send({ kind: 'dome', picture });
  }

  /** Renders a picture; `take` receives its tiles in the order in which they are finished. */
  render(
    request: TileRequest,
    tiles: readonly ImageTile[],
    take: (tile: ImageTile, data: TileData) => void,
  ): Promise<void> {
    if (!this.failure) for (const thread of this.threads) thread.send({ kind: 'picture', request });
    return this.work(
      tiles.map((tile) => ({ kind: 'tile', tile })),
      take,
    );
  }

  /** Denoises tiles of a picture; `take` receives their `beauty`. */
  denoise(
    tiles: readonly { readonly tile: ImageTile; readonly noisy: NoisyTile }[],
    take: (tile: ImageTile, data: TileData) => void,
  ): Promise<void> {
    return this.work(
      tiles.map((order) => ({ kind: 'denoise', ...order })),
      take,
    );
  }

  private work(orders: readonly TileOrder[], take: (tile: ImageTile, data: TileData) => void): Promise<void> {
    if (this.failure) return Promise.reject(this.failure);
    return new Promise((done, fail) => {
      this.job = { orders: [...orders].reverse(), left: orders.length, onTile: take, done, fail };
      for (const thread of this.threads) this.sendNextTile(thread);
    });
  }

  /** Terminates all threads at once, and rejects the current picture. */
  stop(error: Error): void {
    if (this.failure) return;
    this.failure = error;
    for (const thread of this.threads) void thread.terminate();
    this.job?.fail(error);
    this.job = undefined;
  }

  async close(): Promise<void> {
    this.failure ??= new Error('the pool is closed');
    await Promise.all(this.threads.map((thread) => thread.terminate()));
  }

  private onReply(thread: TracerThread, reply: TracerReply): void {
    if (reply.kind === 'failed') this.stop(this.explain(new Error(`in a worker thread: ${reply.message}`)));
    const { job } = this;
    if (!job || reply.kind === 'failed') return;
    job.onTile(reply.tile, reply.data);
    job.left--;
    this.sendNextTile(thread);
    if (job.left > 0) return;
    this.job = undefined;
    job.done();
  }

  private sendNextTile(thread: TracerThread): void {
    const order = this.job?.orders.pop();
    if (order) thread.send(order);
  }
}

/** Small enough that threads finish at about the same time, large enough that messages cost nothing [px]. */
const TILE_SIZE = 16;

/** The tiles of a picture, row by row. */
export const tilesOf = (size: Pick<TileRequest, 'width' | 'height'>): ImageTile[] => squaresOfPicture(size, TILE_SIZE);

/** Renders a whole picture, in the requested layers. `onProgress` receives the finished fraction, 0 … 1. */
export async function renderWithPool(
  pool: TracerPool,
  request: TileRequest,
  onProgress: (fraction: number) => void = () => {},
): Promise<Map<OutputLayer, Float32Array<ArrayBuffer>>> {
  const { width, height, layers } = request;
  const images = new Map(layers.map((layer) => [layer, new Float32Array(width * height * channelsOf(layer))]));
  const tiles = tilesOf(request);
  let done = 0;
  await pool.render(request, tiles, (tile, data) => {
    for (const [layer, image] of images) copyTile(image, width, tile, data[layer]);
    done++;
    onProgress(done / tiles.length);
  });
  return images;
}

/** Copies the rows of a tile into the picture. */
export function copyTile(
  image: Float32Array,
  width: number,
  { x0, y0, x1, y1 }: ImageTile,
  part: Float32Array | undefined,
): void {
  if (!part) return;
  const values = part.length / ((x1 - x0) * (y1 - y0));
  const row = values * (x1 - x0);
  for (let y = y0; y < y1; y++) {
    image.set(part.subarray((y - y0) * row, (y - y0 + 1) * row), values * (y * width + x0));
  }
}
