import type { Vec3 } from '../math/vec3.ts';
import type { ShadowDetailName } from './shadows/shadowDetail.ts';

/** What is seen in one pixel. */
export interface PickResult {
  /** Linear sRGB radiance before exposure and tone mapping. */
  readonly light: Vec3;
  /** Of the opaque surface there; undefined: none. */
  readonly surface?: PickedSurface;
}

export interface PickedSurface {
  /** Place in `Scene.objects` plus one. */
  readonly objectId: number;
  readonly path: string;
  /** World time of the event that is seen [s]. */
  readonly emissionTime: number;
  /** Its world position [m]. */
  readonly position: Vec3;
  /** Of the surface there, world frame, units of c. */
  readonly velocity: Vec3;
  readonly doppler: number;
  /** Apparent distance [m]. */
  readonly depth: number;
}

/**
 * Where a picture's samples are. n: n × n in every pixel, 1: in its centre, and edges are smoothed by FXAA. `temporal`: one, somewhere in its
 * pixel, blended with what is left of the pictures that were made before.
 */
export type Sampling = number | 'temporal';

/** Views that one picture can have: what puts them together reads one texture of each, and WebGL2 and WebGPU grant 16. */
export const MAX_VIEWS = 16;

export type Backend = 'webgpu' | 'webgl';

export interface RendererOptions {
  /** Where the picture is shown. Absent: nothing is shown and the picture is read back. */
  readonly canvas?: HTMLCanvasElement;
  /** A device opened by the caller (Dawn in Node); it should carry the adapter's `maxColorAttachmentBytesPerSample`. */
  readonly device?: GPUDevice;
  /** `auto`: WebGPU where there is an adapter, else WebGL2. */
  readonly backend?: Backend | 'auto';
  /**
   * How far the straight edges that are drawn may be from the curves that are seen [px]; default 0.25. ∞: triangles are drawn as they are in
   * the scene, for comparing.
   */
  readonly tolerance?: number;
  /**
   * Makes a worker that plans how edges are cut (`servePlans` of refine/planServer.ts), off the thread that draws: a picture is then drawn with the
   * plan of a moment ago, wherever that is nearly its own. Absent: plans are made while rendering.
   */
  readonly tessellationWorker?: () => Worker;
  /** Called when the worker has a plan that fits the last picture better than its own: time to render it again. */
  readonly onBetterTessellation?: () => void;
  /** `coarse`: cheaper shadows, less sharp and of fewer moving things, for a software GPU; default `fine`. */
  readonly shadowDetail?: ShadowDetailName;
  /** Texels (16 bytes each) that the samples of one deforming mesh may take on the GPU; default 2²⁴. */
  readonly maxPointTexels?: number;
  /**
   * Makes a worker that reads samples which are left in files (`serveSamples` of sampleServer.ts), off the thread that draws: a picture for
   * which they have not come is not made, and the last one stays (`RendererInfo.waiting`). Absent: they are read while rendering.
   */
  readonly sampleWorker?: () => Worker;
  /** Called when samples have come: where a picture waits, it is time to render it again. */
  readonly onSamples?: () => void;
  /** Called once when samples cannot be read any more: the file is gone or changed. The last picture stays. */
  readonly onError?: (error: Error) => void;
  /** Called once when the device or the context is lost; dispose this renderer and create another on a new canvas. */
  readonly onLost?: (reason: string) => void;
}

export interface RendererInfo {
  readonly backend: Backend;
  /** Drawn in the last frame, after culling. */
  readonly triangles: number;
  /** How far the straight edges drawn in the last frame may be from the curves that are seen [px]; more than asked for where there would be too many. */
  readonly tolerance: number;
  /** As wide, and as high, as this device’s pictures can be [px]. */
  readonly maxTextureSize: number;
  readonly objectsDrawn: number;
  readonly objects: number;
  /** The last picture asked for was not made: samples of a deforming mesh are on their way. */
  readonly waiting: boolean;
  /** CPU time of the last `render` call [ms]; the GPU may still be at work. */
  readonly milliseconds: number;
}
