import { CancelledError } from '../graph/evaluate.ts';
import type { Cancellation, Progress } from '../graph/nodeType.ts';
import type { TileRequest } from '../reference/tile.ts';
import type { Scene } from '../scene/types.ts';

/** What a picture by the reference renderer is to be; its speed of light is that of the settings. */
export type TracedPicture = Omit<TileRequest, 'layers'>;

/**
 * Has a picture drawn by the reference renderer, in threads: linear light, three values per pixel, rows from the top. Rejects with a `CancelledError`
 * where the signal says so; `progress` hears which part is done.
 */
export type Trace = (
  scene: Scene,
  picture: TracedPicture,
  work: { readonly signal?: Cancellation; readonly progress: Progress },
) => Promise<Float32Array<ArrayBuffer>>;

/** One picture after another, for each takes all threads that there are. */
export function inTurn(trace: Trace): Trace {
  let before: Promise<unknown> = Promise.resolve();
  return (scene, picture, work) => {
    const drawn = before.then(() => {
      if (work.signal?.aborted) throw new CancelledError();
      return trace(scene, picture, work);
    });
    before = drawn.catch(() => {});
    return drawn;
  };
}
