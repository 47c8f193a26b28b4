import type { Vec4 } from '../../../shaders/types.ts';

/** What is drawn over a tone-mapped picture: layers of (linear colour, coverage), the lowest first. For use within a shader function. */
export interface PictureOverlay {
  /** Identifies its shaders within one view. */
  readonly key: string;
  /** All layers. */
  layers(): readonly Vec4[];
  /** Those that leave false colours readable: the contours of a ghost. */
  contours(): readonly Vec4[];
}
