import type { Order, Reply } from './serve.ts';
import { channelsOf, type Layer, type Tile, type TileData, type TileRequest } from './tile.ts';

/** A thread that serves (serve.ts), seen from outside; what carries the messages is given. */
export interface TracerThread {
  send(order: Order): void;
  /** What it answers, and what ends it; called once. */
  listen(hear: (reply: Reply) => void, fail: (error: Error) => void): void;
  end(): Promise<unknown> | undefined;
}

/** A picture that is being drawn: what is left to do, and whom to tell. */
interface Work {
  readonly tiles: Tile[];
  left: number;
  readonly take: (tile: Tile, data: TileData) => void;
  readonly done: () => void;
  readonly fail: (error: Error) => void;
}

/**
 * Threads that draw the tiles of one scene's pictures. Each takes the next tile when it has finished one, and a tile's bits do not depend on
 * who draws it. Whatever goes wrong in a thread ends the picture, and with it all threads.
 */
export class TracerPool {
  private readonly threads: readonly TracerThread[];
  private readonly explain: (error: Error) => Error;
  private work: Work | undefined;
  private broken: Error | undefined;

  /** `explain`: what went wrong in a thread, in words for people. */
  constructor(
    threads: readonly TracerThread[],
    scene: Extract<Order, { readonly kind: 'scene' }>,
    explain: (error: Error) => Error = (error) => error,
  ) {
    this.threads = threads;
    this.explain = explain;
    for (const thread of threads) {
      thread.listen(
        (reply) => this.hear(thread, reply),
        (error) => this.stop(explain(error)),
      );
      thread.send(scene);
    }
  }

  /** Draws a picture; `take` gets its tiles in the order in which they are finished. */
  draw(request: TileRequest, tiles: readonly Tile[], take: (tile: Tile, data: TileData) => void): Promise<void> {
    if (this.broken) return Promise.reject(this.broken);
    return new Promise((done, fail) => {
      this.work = { tiles: [...tiles].reverse(), left: tiles.length, take, done, fail };
      for (const thread of this.threads) {
        thread.send({ kind: 'picture', request });
        this.feed(thread);
      }
    });
  }

  /** Ends all threads at once, and the picture with an error. */
  stop(error: Error): void {
    if (this.broken) return;
    this.broken = error;
    for (const thread of this.threads) void thread.end();
    this.work?.fail(error);
    this.work = undefined;
  }

  async close(): Promise<void> {
    this.broken ??= new Error('the pool is closed');
    await Promise.all(this.threads.map((thread) => thread.end()));
  }

  private hear(thread: TracerThread, reply: Reply): void {
    if (reply.kind === 'failed') this.stop(this.explain(new Error(`in a worker thread: ${reply.message}`)));
    const { work } = this;
    if (!work || reply.kind === 'failed') return;
    work.take(reply.tile, reply.data);
    work.left--;
    this.feed(thread);
    if (work.left > 0) return;
    this.work = undefined;
    work.done();
  }

  private feed(thread: TracerThread): void {
    const tile = this.work?.tiles.pop();
    if (tile) thread.send({ kind: 'tile', tile });
  }
}

/** Small enough that the threads end together, large enough that telling of them costs nothing [px]. */
const TILE = 16;

/** A picture in tiles, row by row. */
export function tilesOf({ width, height }: Pick<TileRequest, 'width' | 'height'>): Tile[] {
  const tiles: Tile[] = [];
  for (let y0 = 0; y0 < height; y0 += TILE) {
    for (let x0 = 0; x0 < width; x0 += TILE) {
      tiles.push({ x0, y0, x1: Math.min(x0 + TILE, width), y1: Math.min(y0 + TILE, height) });
    }
  }
  return tiles;
}

/** A whole picture, in the layers that are asked for. `onPart` hears which part is done, 0 … 1. */
export async function drawnBy(
  pool: TracerPool,
  request: TileRequest,
  onPart: (part: number) => void = () => {},
): Promise<Map<Layer, Float32Array<ArrayBuffer>>> {
  const { width, height, layers } = request;
  const images = new Map(layers.map((layer) => [layer, new Float32Array(width * height * channelsOf(layer))]));
  const tiles = tilesOf(request);
  let done = 0;
  await pool.draw(request, tiles, (tile, data) => {
    for (const [layer, image] of images) place(image, width, tile, data[layer]);
    done++;
    onPart(done / tiles.length);
  });
  return images;
}

/** Puts the rows of a tile where they belong. */
function place(image: Float32Array, width: number, { x0, y0, x1, y1 }: Tile, part: Float32Array | undefined): void {
  if (!part) return;
  const values = part.length / ((x1 - x0) * (y1 - y0));
  const row = values * (x1 - x0);
  for (let y = y0; y < y1; y++) {
    image.set(part.subarray((y - y0) * row, (y - y0 + 1) * row), values * (y * width + x0));
  }
}
