import { setSampleCacheSize } from '../scene/streaming/streamedPoints.ts';
import { fromPreparedScene, type PreparedScene, type TracedScene } from './intersection/tracedScene.ts';
import { renderTile } from './tile.ts';
import type { ImageTile, TileData, TileRequest } from './tileRequest.ts';

/** What a thread that draws tiles is told, in this order: a scene, then for each picture what it is to be, then its tiles. */
export type TracerMessage =
  | { readonly kind: 'scene'; readonly ground: PreparedScene; readonly shapes: number }
  | { readonly kind: 'picture'; readonly request: TileRequest }
  | { readonly kind: 'tile'; readonly tile: ImageTile };

/** What it answers: each tile once, or why there will be none. */
export type TracerReply =
  | { readonly kind: 'tile'; readonly tile: ImageTile; readonly data: TileData }
  | { readonly kind: 'failed'; readonly message: string };

/** The thread's end of a line to whoever gives it work. */
export interface TracerPort {
  listen(hear: (order: TracerMessage) => void): void;
  /** `transfer`: memory that is handed over instead of copied. */
  post(reply: TracerReply, transfer: readonly ArrayBufferLike[]): void;
}

/** Draws what the port orders, as long as the thread lives. */
export function serveTracer(port: TracerPort): void {
  let scene: TracedScene | undefined;
  let request: TileRequest | undefined;
  const obey = (order: TracerMessage): void => {
    if (order.kind === 'scene') {
      setSampleCacheSize(order.shapes / 4);
      scene = fromPreparedScene(order.ground, order.shapes);
    } else if (order.kind === 'picture') request = order.request;
    else if (!scene || !request) throw new Error('a tile was ordered before its scene and its picture');
    else {
      const data = renderTile(scene, request, order.tile);
      port.post(
        { kind: 'tile', tile: order.tile, data },
        Object.values(data).map((values) => values.buffer),
      );
    }
  };
  port.listen((order) => {
    try {
      obey(order);
    } catch (error) {
      port.post({ kind: 'failed', message: (error instanceof Error && error.stack) || String(error) }, []);
    }
  });
}
