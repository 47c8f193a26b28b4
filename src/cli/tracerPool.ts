import { type ResourceLimits, Worker } from 'node:worker_threads';
import type { Order, Reply } from '../reference/serve.ts';
import type { Tile, TileData, TileRequest } from '../reference/tile.ts';
import { groundwork } from '../reference/trace.ts';
import type { Scene } from '../scene/types.ts';
import { unavailable } from './exit.ts';
import { shared } from './shared.ts';

/** Memory for the shapes of sampled objects at their samples: of all threads, and of one [bytes]. */
const [SHAPES, MOST_SHAPES] = [4 * 2 ** 30, 256 * 2 ** 20];

export interface PoolOptions {
  readonly threads: number;
  /** Of each thread; Node's own where absent. */
  readonly limits?: ResourceLimits;
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
 * Worker threads that draw the tiles of one scene's pictures. Each takes the next tile when it has finished one, and a tile's bits do
 * not depend on who draws it. Whatever goes wrong in a thread ends the picture, and with it all threads.
 */
export class TracerPool {
  private readonly workers: readonly Worker[];
  private work: Work | undefined;
  private broken: Error | undefined;

  constructor(scene: Scene, speedOfLight: number, { threads, limits }: PoolOptions) {
    const order: Order = {
      kind: 'scene',
      ground: shared(groundwork(scene, speedOfLight)),
      shapes: Math.min(MOST_SHAPES, SHAPES / threads),
    };
    this.workers = Array.from({ length: threads }, () => this.start(order, limits));
  }

  /** Draws a picture; `take` gets its tiles in the order in which they are finished. */
  draw(request: TileRequest, tiles: readonly Tile[], take: (tile: Tile, data: TileData) => void): Promise<void> {
    if (this.broken) return Promise.reject(this.broken);
    return new Promise((done, fail) => {
      this.work = { tiles: [...tiles].reverse(), left: tiles.length, take, done, fail };
      for (const worker of this.workers) {
        tell(worker, { kind: 'picture', request });
        this.feed(worker);
      }
    });
  }

  /** Ends all threads at once, and the picture with an error. */
  stop(error: Error): void {
    if (this.broken) return;
    this.broken = error;
    for (const worker of this.workers) void worker.terminate();
    this.work?.fail(error);
    this.work = undefined;
  }

  async close(): Promise<void> {
    this.broken ??= new Error('the pool is closed');
    await Promise.all(this.workers.map((worker) => worker.terminate()));
  }

  private start(order: Order, limits: ResourceLimits | undefined): Worker {
    const worker = new Worker(new URL('./tracerWorker.js', import.meta.url), { resourceLimits: limits });
    worker.on('message', (reply: Reply) => this.hear(worker, reply));
    worker.on('error', (error: NodeJS.ErrnoException) => this.stop(explained(error)));
    worker.on('exit', (code) => this.stop(new Error(`a worker thread ended by itself, with ${code}`)));
    tell(worker, order);
    return worker;
  }

  private hear(worker: Worker, reply: Reply): void {
    if (reply.kind === 'failed') this.stop(explained(new Error(`in a worker thread: ${reply.message}`)));
    const { work } = this;
    if (!work || reply.kind === 'failed') return;
    work.take(reply.tile, reply.data);
    work.left--;
    this.feed(worker);
    if (work.left > 0) return;
    this.work = undefined;
    work.done();
  }

  private feed(worker: Worker): void {
    const tile = this.work?.tiles.pop();
    if (tile) tell(worker, { kind: 'tile', tile });
  }
}

const tell = (worker: Worker, order: Order): void => worker.postMessage(order);

function explained(error: NodeJS.ErrnoException): Error {
  const outOfMemory = error.code === 'ERR_WORKER_OUT_OF_MEMORY' || error.message.includes('allocation failed');
  if (!outOfMemory) return error;
  return unavailable(
    'a thread of the reference renderer ran out of memory. Use fewer --threads, or let each have more: NODE_OPTIONS=--max-old-space-size=8192 [MiB]',
  );
}
