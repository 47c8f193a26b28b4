import type { FrameGraph, FrameGraphPassOf } from '../scene/frameGraph/frameGraph.ts';
import type { SettingOfNode, ValuesOf } from '../scene/settings/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { FalseColorQuantity } from '../spectrum/falseColor/falseColor.ts';
import type { LoadedScene } from './services.ts';

/** A scene with how light travels in it. */
export interface RelativisticScene extends LoadedScene, ValuesOf<SettingOfNode<'relativity-console'>> {
  /** [m/s] */
  readonly speedOfLight: number;
  /** The observer's greatest speed, as a fraction of c. */
  readonly maxSpeed: number;
}

/** A scene with where it is looked at from. */
export interface CameraView extends RelativisticScene {
  /** Prim path; empty: the scene's first camera. */
  readonly camera: string;
  /** The observer rides on the file's camera, with its velocity, instead of flying freely. */
  readonly ride: boolean;
  /** Vertical field of view [rad]; undefined: the camera's own. */
  readonly fovY: number | undefined;
}

/** What the rasterizer is to draw. A description: the pass itself runs once a frame. */
export interface GBufferSpec extends CameraView, ValuesOf<SettingOfNode<'relativity-rasterize'>> {}

/** An image, by the step that makes it of others; nothing is drawn before the whole picture is known. */
export interface ImageSpec {
  readonly step: FrameGraphPassOf<ImageSpec, GBufferSpec>;
  /** The G-buffer that the picture is of, first of all: whose camera, time and speed of light hold for it. */
  readonly gbuffer: GBufferSpec;
}

/** A whole picture, but for the time and the observer, which change by themselves. */
export interface PictureSpec extends GBufferSpec, ValuesOf<SettingOfNode<'deferred-lighting' | 'tone-map'>> {
  /** What hides the sky of a place dims its light. */
  readonly occlusion: boolean;
  readonly falseColor: FalseColorQuantity | 'none';
  /** Where it is more than one G-buffer, shaded: how it is put together. */
  readonly frameGraph?: FrameGraph;
  /** What it was planned of. */
  readonly image: ImageSpec;
  /** What the plan's other G-buffers are of, with that of the first. */
  readonly scenes: readonly Scene[];
}

/** From when to when a scene's animation is shown [s]. */
export interface TimeRange {
  readonly start: number;
  readonly end: number;
  /** World time that it opens at; absent: its start. */
  readonly openAt?: number;
}
