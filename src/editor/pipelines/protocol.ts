/** What the worker that draws a still (a `StillOrder`, its only message) answers. */
export type StillReply =
  | { readonly kind: 'progress'; readonly part: number }
  | { readonly kind: 'done'; readonly pixels: Float32Array<ArrayBuffer> }
  | { readonly kind: 'failed'; readonly message: string };
