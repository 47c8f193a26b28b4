import type { FrameGraph, FrameGraphPassOf } from '../scene/frameGraph/frameGraph.ts';
import type { SettingOfNode, ValuesOf } from '../scene/settings/settings.ts';
import type { CameraCourse, Scene } from '../scene/types.ts';
import type { CaptureSettings } from '../scene/view/capture.ts';
import type { PanoramicLens } from '../scene/view/lenses/lenses.ts';
import type { OutsideCamera } from '../scene/view/outsideCamera.ts';
import type { FalseColorQuantity } from '../spectrum/falseColor/falseColor.ts';
import type { LoadedScene } from './services.ts';

/** A scene with how light travels in it. */
export interface RelativisticScene extends LoadedScene, ValuesOf<SettingOfNode<'relativity-console'>> {
  /** [m/s] */
  readonly speedOfLight: number;
  /** The observer's maximum speed as a fraction of c. */
  readonly maxSpeed: number;
}

/** A relativistic scene with the camera that observes it. */
export interface CameraView extends RelativisticScene {
  /** Prim path; empty: the scene's first camera. */
  readonly camera: string;
  /** Whether the observer rides on the file's camera with its velocity instead of flying freely. */
  readonly ride: boolean;
  /** Whether one who rides goes through the camera's samples on a smooth way; else along straight pieces. */
  readonly smooth: boolean;
  /** That way, if he rides in the page. Films, which follow the camera in any case, make it themselves. */
  readonly course?: CameraCourse;
  /** Vertical field of view [rad]; undefined: the camera's. */
  readonly fovY: number | undefined;
  /** Replaces the camera's lens; absent: a perspective one. */
  readonly panorama?: PanoramicLens;
  /** Looks at the camera's picture from outside; absent: it is seen through the camera. */
  readonly outside?: OutsideCamera;
  /** Takes what is seen from a capture; absent: it is drawn. */
  readonly capture?: CaptureSettings;
}

/** What the rasterizer is to draw. A description only: the pass runs once per frame. */
export interface GBufferSpec extends CameraView, ValuesOf<SettingOfNode<'relativity-rasterize'>> {}

/** An image, described by the pass that makes it from others; nothing is rendered before the whole picture is known. */
export interface ImageSpec {
  /** The pass, and the images that it takes. */
  readonly step: FrameGraphPassOf<ImageSpec, GBufferSpec>;
  /** The primary G-buffer, whose camera, time and speed of light apply to the image. */
  readonly gbuffer: GBufferSpec;
}

/** A whole picture, except for time and observer, which change without an evaluation. */
export interface PictureSpec extends GBufferSpec, ValuesOf<SettingOfNode<'deferred-lighting' | 'tone-map'>> {
  /** Whether ambient occlusion dims the light of the sky. */
  readonly occlusion: boolean;
  /** What is displayed as colours. */
  readonly falseColor: FalseColorQuantity | 'none';
  /** Present if the picture is more than one shaded G-buffer. */
  readonly frameGraph?: FrameGraph;
  /** The final image. */
  readonly image: ImageSpec;
  /** Scenes of all G-buffers; the primary one's first. */
  readonly scenes: readonly Scene[];
}

/** Time range in which a scene's animation is shown [s]. */
export interface TimeRange {
  readonly start: number;
  readonly end: number;
  /** Initial world time [s]; absent: the start. */
  readonly openAt?: number;
}
