import type { Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import type { FalseColorScale } from '../../spectrum/falseColor/falseColor.ts';
import type { FrameGraph, FrameGraphBuffer } from '../frameGraph/frameGraph.ts';
import { RENDERER_SETTINGS, type RendererSettings, settingNamed } from '../settings/settings.ts';
import type { View } from '../views/views.ts';
import type { CaptureSettings } from './capture.ts';
import type { Lens } from './lenses/lenses.ts';
import type { OutsideCamera } from './outsideCamera.ts';

/** Settings of a picture. Plain data, so that documents, flags and sockets can hold them. */
export interface RenderSettings extends RendererSettings {
  /** Displays values as colours instead of the light. */
  readonly falseColors?: FalseColorScale;
  /** The frame graph applied to linear light before exposure; absent: none. */
  readonly frameGraph?: FrameGraph;
  /** Looks at the picture's first G-buffer from outside; absent: it is seen with the observer's eye. */
  readonly outside?: OutsideCamera;
  /** Takes the first G-buffer from a capture; absent: it is drawn. */
  readonly capture?: CaptureSettings;
  /** [m/s] */
  readonly speedOfLight: number;
}

/** Defaults of the settings that have one. */
const DEFAULTS = Object.fromEntries(
  RENDERER_SETTINGS.flatMap((name) => {
    const { default: value } = settingNamed(name);
    return value === undefined ? [] : [[name, value]];
  }),
) as unknown as RendererSettings;

/**
 * What a picture has if nothing else is said.
 * @example
 * DEFAULT_SETTINGS.speedOfLight; // 299792458 m/s
 * DEFAULT_SETTINGS.beaming; // 1
 */
export const DEFAULT_SETTINGS: RenderSettings = { ...DEFAULTS, speedOfLight: SPEED_OF_LIGHT };

/** The G-buffers of a picture but for the first, which is that of `settings` themselves: those of its frame graph, then that of its ghost. */
export function extraBuffers(settings: RenderSettings): readonly FrameGraphBuffer[] {
  const { frameGraph, ghost } = settings;
  const own = frameGraph?.extraBuffers ?? [];
  return ghost === 'none' ? own : [...own, ghostBuffer(settings, ghost)];
}

/** Contours have no light. From outside, what is seen is shown where it was in the world. */
const ghostBuffer = (settings: RenderSettings, view: View): FrameGraphBuffer => ({
  ...settings,
  ...{ scene: 0, view, lightDelay: true, aberration: !settings.outside, shadows: false, occlusionRadius: 0 },
});

/** The settings of a picture's G-buffer; 0 is that of `settings` themselves. */
export function bufferSettings(settings: RenderSettings, buffer: number): RenderSettings {
  if (buffer === 0) return settings;
  const { outside: _, capture: __, ...shared } = settings;
  return { ...shared, ...extraBuffers(settings)[buffer - 1] };
}

/** The observer's event, velocity and camera. */
export interface ViewPoint {
  /** World time [s]. */
  readonly t: number;
  /** World frame [m]. */
  readonly position: Vec3;
  /** Proper velocity γβ, world frame. */
  readonly u: Vec3;
  /** Camera axes (−Z forward, +Y up) against the world axes carried by the pure boost. */
  readonly orientation: Quat;
  /** In the observer's frame. */
  readonly lens: Lens;
  /**
   * From the observer to the camera that looks at what he sees, in his space: world axes carried by the boost [m]. Absent: the camera is at his eye. The
   * picture of a vantage is that of a snapshot: everything stays where, and as, the observer sees it, and is looked at from elsewhere.
   */
  readonly vantage?: Vec3;
}

/** The names of the data channels; docs/conventions.md explains each. */
export type AovName =
  | 'beauty'
  | 'albedo'
  | 'depth'
  | 'emission_time'
  | 'emission_time_relative'
  | 'doppler'
  | 'position'
  | 'normal'
  | 'roughness'
  | 'metallic'
  | 'occlusion'
  | 'velocity'
  | 'object'
  | 'sample_count';

/** AOVs of the surface. */
export type DataAov = Exclude<AovName, 'beauty' | 'sample_count'>;

/** A data channel of pictures. */
export interface AovInfo {
  /** EXR channel names, in the order of the values of a pixel. */
  readonly channels: readonly string[];
  /** For people. */
  readonly meaning: string;
}

/**
 * The AOVs. In data AOVs, pixels without a surface are 0; `beauty` has the sky there, and `sample_count` is that of `beauty`. Data AOVs describe the surface at the pixel's centre and are never
 * averaged.
 * @example
 * AOVS.depth.channels; // ['depth']
 */
export const AOVS: Readonly<Record<AovName, AovInfo>> = {
  beauty: { channels: ['R', 'G', 'B'], meaning: 'linear sRGB radiance before exposure and tone mapping' },
  albedo: {
    channels: ['albedo.R', 'albedo.G', 'albedo.B'],
    meaning: 'linear sRGB base colour of the surface, with its texture and vertex colour',
  },
  depth: { channels: ['depth'], meaning: "apparent distance |Δx'| in the observer frame [m]" },
  emission_time: { channels: ['emission_time'], meaning: 'world time of the event that is seen [s]' },
  emission_time_relative: {
    channels: ['emission_time_relative'],
    meaning: "world time of the event that is seen minus that of the observer's [s]; as accurate at any time",
  },
  doppler: { channels: ['doppler'], meaning: 'D = ν_observed/ν_emitted' },
  position: {
    channels: ['position.x', 'position.y', 'position.z'],
    meaning: 'world position of the event that is seen [m]',
  },
  normal: {
    channels: ['normal.x', 'normal.y', 'normal.z'],
    meaning: 'unit normal in the rest frame of the surface, on the world axes carried there by the pure boost',
  },
  roughness: { channels: ['roughness'], meaning: 'roughness of the surface, with its texture, 0 … 1' },
  metallic: { channels: ['metallic'], meaning: 'how metallic the surface is, with its texture, 0 … 1' },
  occlusion: {
    channels: ['occlusion'],
    meaning:
      'share of the sky that the surface sees in its rest frame, weighted by the cosine: 1 where nothing hides it',
  },
  velocity: {
    channels: ['velocity.x', 'velocity.y', 'velocity.z'],
    meaning: 'velocity of the surface in the world frame, in units of c',
  },
  object: { channels: ['object'], meaning: 'place of the object in Scene.objects plus one' },
  sample_count: { channels: ['sample_count'], meaning: 'number of samples of beauty' },
};
