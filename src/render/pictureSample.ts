import type { PerspectiveCamera } from 'three/webgpu';
import type { Capture } from './capture/capture.ts';
import type { CapturedGBufferView } from './deferredPass.ts';
import type { PictureFace } from './lenses/pictureFaces.ts';
import type { SamplePosition } from './post/resolve/pixelSamples.ts';

/** The view of a G-buffer, and how its uniforms are set. */
export interface BoundRenderView {
  readonly view: CapturedGBufferView;
  /** Sets the uniforms and the camera; of a face, also prepares its scene. */
  readonly bind: () => void;
}

/** A face of a panoramic picture. */
export interface BoundFace {
  readonly face: PictureFace;
  /** Of the sample within its pixels. */
  readonly position: SamplePosition;
  /** By G-buffer; undefined for one whose own lens is a perspective one. */
  readonly views: readonly (BoundRenderView | undefined)[];
}

/** A capture that is to be drawn first, and its faces. */
export interface DueCapture {
  readonly capture: Capture;
  readonly faces: readonly BoundRenderView[];
  /** Whether better plans for its faces are being made than those that they were drawn with. */
  readonly awaitsBetter: () => boolean;
}

/** What one sample of a picture is drawn with. */
export interface PictureSample {
  /** By G-buffer. */
  readonly views: readonly [BoundRenderView, ...BoundRenderView[]];
  readonly captures: readonly DueCapture[];
  /** The faces that G-buffers with a panoramic lens are gathered from; empty if there is none. */
  readonly faces: readonly BoundFace[];
  readonly camera: PerspectiveCamera;
  /** World time of the observer [s]. */
  readonly time: number;
}
