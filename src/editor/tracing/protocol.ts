import type { TraceOptions } from '../../nodes/trace.ts';
import type { Scene } from '../../scene/types.ts';

/** Request to the worker that traces a picture; sent once. */
export interface TraceRequest {
  readonly scene: Scene;
  readonly picture: TraceOptions;
}

/** Its replies. */
export type TraceReply =
  | { readonly kind: 'progress'; readonly part: number }
  | { readonly kind: 'done'; readonly pixels: Float32Array<ArrayBuffer> }
  | { readonly kind: 'failed'; readonly message: string };
