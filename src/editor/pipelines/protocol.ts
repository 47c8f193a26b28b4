import type { Message } from '../../messages/message.ts';

/** Replies of the worker that renders a still; its only message is a `StillOrder`. */
export type StillReply =
  | { readonly kind: 'progress'; readonly part: number }
  | { readonly kind: 'done'; readonly pixels: Float32Array<ArrayBuffer> }
  | { readonly kind: 'failed'; readonly message: Message };
