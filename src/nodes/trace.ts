import { CancelledError } from '../graph/evaluation/evaluator.ts';
import type { AbortSignalLike, ProgressCallback } from '../graph/nodeType.ts';
import type { TileRequest } from '../reference/tileRequest.ts';
import type { Scene } from '../scene/types.ts';

/** Request for a reference picture; its speed of light is that of the settings. */
export type TraceOptions = Omit<TileRequest, 'layers'>;

/**
 * Renders a picture with the reference renderer in threads: linear radiance, three values per pixel, rows from the top.
 * Rejects with a `CancelledError` on the signal; `progress` gets the completed fraction.
 */
export type ReferenceTrace = (
  scene: Scene,
  picture: TraceOptions,
  work: { readonly signal?: AbortSignalLike; readonly progress: ProgressCallback },
) => Promise<Float32Array<ArrayBuffer>>;

/** Runs one trace after another, since each uses all threads. */
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
