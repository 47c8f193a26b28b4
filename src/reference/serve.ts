import { keepSamplesIn } from '../scene/streamedPoints.ts';
import { renderTile, type Tile, type TileData, type TileRequest } from './tile.ts';
import { type Groundwork, type TracedScene, traced } from './trace.ts';

/** What a thread that draws tiles is told, in this order: a scene, then for each picture what it is to be, then its tiles. */
export type Order =
  | { readonly kind: 'scene'; readonly ground: Groundwork; readonly shapes: number }
  | { readonly kind: 'picture'; readonly request: TileRequest }
  | { readonly kind: 'tile'; readonly tile: Tile };

/** What it answers: each tile once, or why there will be none. */
export type Reply =
  | { readonly kind: 'tile'; readonly tile: Tile; readonly data: TileData }
  | { readonly kind: 'failed'; readonly message: string };

/** The thread's end of a line to whoever gives it work. */
export interface Port {
  listen(hear: (order: Order) => void): void;
  /** `transfer`: memory that is handed over instead of copied. */
  answer(reply: Reply, transfer: readonly ArrayBufferLike[]): void;
}

/** Draws what the port orders, as long as the thread lives. */
export function serve(port: Port): void {
  let scene: TracedScene | undefined;
  let request: TileRequest | undefined;
  const obey = (order: Order): void => {
    if (order.kind === 'scene') {
      keepSamplesIn(order.shapes / 4);
      scene = traced(order.ground, order.shapes);
    } else if (order.kind === 'picture') request = order.request;
    else if (!scene || !request) throw new Error('a tile was ordered before its scene and its picture');
    else {
      const data = renderTile(scene, request, order.tile);
      port.answer(
        { kind: 'tile', tile: order.tile, data },
        Object.values(data).map((values) => values.buffer),
      );
    }
  };
  port.listen((order) => {
    try {
      obey(order);
    } catch (error) {
      port.answer({ kind: 'failed', message: (error instanceof Error && error.stack) || String(error) }, []);
    }
  });
}
