import { CancelledError } from '../graph/evaluation/evaluator.ts';
import type { AbortSignalLike, ProgressCallback } from '../graph/nodeType.ts';
import type { TileRequest } from '../reference/tileRequest.ts';
import type { Scene } from '../scene/types.ts';

/** What a picture by the reference renderer is to be; its speed of light is that of the settings. */
export type TraceOptions = Omit<TileRequest, 'layers'>;

/**
 * Has a picture drawn by the reference renderer, in threads: linear light, three values per pixel, rows from the top. Rejects with a `CancelledError`
 * where the signal says so; `progress` hears which part is done.
 */
export type ReferenceTrace = (
  scene: Scene,
  picture: TraceOptions,
  work: { readonly signal?: AbortSignalLike; readonly progress: ProgressCallback },
) => Promise<Float32Array<ArrayBuffer>>;

/** One picture after another, for each takes all threads that there are. */
export function queueTraces(trace: ReferenceTrace): ReferenceTrace {
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
