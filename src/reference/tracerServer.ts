import { withDomePicture } from '../scene/film/seenFilm.ts';
import { setSampleCacheSize } from '../scene/streaming/sampleCache.ts';
import type { DomePicture } from '../scene/types.ts';
import type { NoisyTile } from './denoise/noisyTile.ts';
import { fromPreparedScene, type PreparedScene, type TracedScene } from './intersection/tracedScene.ts';
import { renderTile } from './tile.ts';
import type { ImageTile, TileData, TileRequest } from './tileRequest.ts';

/**
 * Messages to a tracer thread, in this order: a scene, then for each picture its request and its tiles; between pictures another picture of its dome, and
 * tiles to be denoised.
 */
export type TracerMessage =
  | { readonly kind: 'scene'; readonly ground: PreparedScene; readonly shapes: number }
  | { readonly kind: 'dome'; readonly picture: DomePicture }
  | { readonly kind: 'picture'; readonly request: TileRequest }
  | { readonly kind: 'tile'; readonly tile: ImageTile }
  | { readonly kind: 'denoise'; readonly tile: ImageTile; readonly noisy: NoisyTile };

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
  const post = (tile: ImageTile, data: TileData): void =>
    port.post(
      { kind: 'tile', tile, data },
      Object.values(data).map((values) => values.buffer),
    );
  const fail = (error: unknown): void =>
    port.post({ kind: 'failed', message: (error instanceof Error && error.stack) || String(error) }, []);
  const handle = (message: TracerMessage): void => {
    if (message.kind === 'scene') {
      setSampleCacheSize(message.shapes / 4);
      scene = fromPreparedScene(message.ground, message.shapes);
    } else if (message.kind === 'dome')
      scene = scene && { ...scene, scene: withDomePicture(scene.scene, message.picture) };
    else if (message.kind === 'picture') request = message.request;
    else if (message.kind === 'denoise') {
      const { tile, noisy } = message;
      // Imported lazily: the weights are large.
      const loaded = import('./denoise/denoiseTile.ts');
      loaded.then(({ denoiseTile }) => post(tile, { beauty: denoiseTile(tile, noisy) })).catch(fail);
    } else if (!scene || !request) throw new Error('a tile was ordered before its scene and its picture');
    else post(message.tile, renderTile(scene, request, message.tile));
  };
  port.listen((message) => {
    try {
      handle(message);
    } catch (error) {
      fail(error);
    }
  });
}
