import { withDomePicture } from '../scene/film/seenFilm.ts';
import { setSampleCacheSize } from '../scene/streaming/sampleCache.ts';
import type { DomePicture } from '../scene/types.ts';
import { fromPreparedScene, type PreparedScene, type TracedScene } from './intersection/tracedScene.ts';
import { renderTile } from './tile.ts';
import type { ImageTile, TileData, TileRequest } from './tileRequest.ts';

/** Messages to a tracer thread, in this order: a scene, then for each picture its request and its tiles; between pictures another picture of its dome. */
export type TracerMessage =
  | { readonly kind: 'scene'; readonly ground: PreparedScene; readonly shapes: number }
  | { readonly kind: 'dome'; readonly picture: DomePicture }
  | { readonly kind: 'picture'; readonly request: TileRequest }
  | { readonly kind: 'tile'; readonly tile: ImageTile };

/** Replies of a tracer thread: each tile once, or the error. */
export type TracerReply =
  | { readonly kind: 'tile'; readonly tile: ImageTile; readonly data: TileData }
  | { readonly kind: 'failed'; readonly message: string };

/** The thread's end of the message channel. */
export interface TracerPort {
  listen(hear: (message: TracerMessage) => void): void;
  /** `transfer`: memory that is transferred instead of copied. */
  post(reply: TracerReply, transfer: readonly ArrayBufferLike[]): void;
}

/** Handles the port's messages for the lifetime of the thread. */
export function serveTracer(port: TracerPort): void {
  let scene: TracedScene | undefined;
  let request: TileRequest | undefined;
  const handle = (message: TracerMessage): void => {
    if (message.kind === 'scene') {
      setSampleCacheSize(message.shapes / 4);
      scene = fromPreparedScene(message.ground, message.shapes);
    } else if (message.kind === 'dome')
      scene = scene && { ...scene, scene: withDomePicture(scene.scene, message.picture) };
    else if (message.kind === 'picture') request = message.request;
    else if (!scene || !request) throw new Error('a tile was ordered before its scene and its picture');
    else {
      const data = renderTile(scene, request, message.tile);
      port.post(
        { kind: 'tile', tile: message.tile, data },
        Object.values(data).map((values) => values.buffer),
      );
    }
  };
  port.listen((message) => {
    try {
      handle(message);
    } catch (error) {
      port.post({ kind: 'failed', message: (error instanceof Error && error.stack) || String(error) }, []);
    }
  });
}
