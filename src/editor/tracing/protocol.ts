import type { TraceOptions } from '../../nodes/trace.ts';
import type { Scene } from '../../scene/types.ts';

/** What the worker that has pictures traced is told, once. */
export interface TraceRequest {
  readonly scene: Scene;
  readonly picture: TraceOptions;
}

/** What it answers. */
export type TraceReply =
  | { readonly kind: 'progress'; readonly part: number }
  | { readonly kind: 'done'; readonly pixels: Float32Array<ArrayBuffer> }
  | { readonly kind: 'failed'; readonly message: string };
