/**
 * How a G-buffer is taken from a capture: six faces around one event, drawn at rest there once, which show what an observer of any velocity sees there, in any
 * direction (docs/adr/0051-capture.md).
 */
export interface CaptureSettings {
  /** Side of a face [px]; 0: as fine as the picture in the middle of a face. */
  readonly texels: number;
  /** Farthest that anything may be beside its place in the picture before the capture is renewed [px]. */
  readonly maxError: number;
}

/** What a capture has if nothing else is said. */
export const DEFAULT_CAPTURE: CaptureSettings = { texels: 0, maxError: 0.5 };

/** Smallest and largest side of a face [px]; the six of the largest have 1.6 GB on the GPU. */
export const CAPTURE_TEXELS = { min: 16, max: 2048 } as const;
