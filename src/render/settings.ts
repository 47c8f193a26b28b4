import type { Vec3 } from '../math/vec3.ts';
import type { ShadowDetailName } from './shadows/shadowDetail.ts';

/** What one pixel shows. */
export interface PickResult {
  /** Linear sRGB radiance before exposure and tone mapping. */
  readonly light: Vec3;
  /** The opaque surface there; undefined if there is none. */
  readonly surface?: PickedSurface;
}

/** The surface at a pixel and the event at which it is seen. */
export interface PickedSurface {
  /** Index in `Scene.objects` plus one. */
  readonly objectId: number;
  /** Of its object. */
  readonly path: string;
  /** World time of the emission event [s]. */
  readonly emissionTime: number;
  /** Its world position [m]. */
  readonly position: Vec3;
  /** Of the surface at that event, world frame, units of c. */
  readonly velocity: Vec3;
  /** D = ν_observed/ν_emitted. */
  readonly doppler: number;
  /** Apparent distance [m]. */
  readonly depth: number;
}

/**
 * How a picture is sampled. n: n × n samples per pixel; 1: one sample at the centre, antialiased by FXAA. `temporal`: one jittered sample per pixel,
 * blended with the history of previous pictures.
 */
export type Sampling = number | 'temporal';

/**
 * How light is computed: `deferred`, of a G-buffer, which holds all that effects, AOVs, ambient occlusion and false colours read; `forward`, in the pass that
 * draws the surfaces, at about half of the cost on a slow machine.
 */
export type Shading = 'deferred' | 'forward';

/** `auto`: forward where nothing of a picture reads a G-buffer; what reads one later, as `pick` and `readAov`, draws it then. */
export type ShadingChoice = 'auto' | 'deferred';

/** Most views of a picture: `ViewCompositor` reads one texture of each in one pass, and WebGL2 and WebGPU guarantee 16. */
export const MAX_VIEWS = 16;

/** What draws on the GPU. */
export type Backend = 'webgpu' | 'webgl';

/** Where and how it draws. */
export interface RendererOptions {
  /** The canvas to present on; absent: pictures are only read back. */
  readonly canvas?: HTMLCanvasElement;
  /** A device opened by the caller (Dawn in Node); it should carry the adapter's `maxColorAttachmentBytesPerSample`. */
  readonly device?: GPUDevice;
  /** `auto`: WebGPU if there is an adapter, else WebGL2. */
  readonly backend?: Backend | 'auto';
  /**
   * Largest distance of the drawn straight edges from the curves that they approximate [px]; default 0.25. ∞: triangles are drawn without tessellation,
   * for comparison.
   */
  readonly tolerance?: number;
  /**
   * Creates the worker that plans tessellation (`servePlans` of tessellation/plan/planServer.ts). A picture is then drawn with the latest plan if its view
   * is close enough. Absent: plans are made on the rendering thread.
   */
  readonly tessellationWorker?: () => Worker;
  /** Called when the worker has a plan that fits the last picture better than the one it was drawn with: render it again. */
  readonly onBetterTessellation?: () => void;
  /** `coarse`: cheaper shadows, less sharp and of fewer moving objects, for a software GPU; default `fine`. */
  readonly shadowDetail?: ShadowDetailName;
  /** Most texels (16 bytes each) for the samples of one deforming mesh on the GPU; default 2²⁴. */
  readonly maxPointTexels?: number;
  /**
   * Creates the worker that reads streamed samples from files (`serveSamples` of geometry/pointSamples/sampleServer.ts). A picture whose samples are not
   * loaded yet is not drawn, and the last one stays (`RendererInfo.waiting`). Absent: samples are read on the rendering thread.
   */
  readonly sampleWorker?: () => Worker;
  /** Called when samples have been loaded: render a waiting picture again. */
  readonly onSamples?: () => void;
  /** Called once when samples cannot be read any more, because the file was deleted or changed. The last picture stays. */
  readonly onError?: (error: Error) => void;
  /** Called once when the device or the context is lost, also for renderers beside this one; dispose them all and create others on a new canvas. */
  readonly onLost?: (reason: string) => void;
}

/** How a further renderer on the same device draws. Tolerance, workers and callbacks are its own. */
export type BesideOptions = Omit<RendererOptions, 'canvas' | 'device' | 'backend' | 'onLost'>;

/** What draws, and what the last frame cost. */
export interface RendererInfo {
  /** What draws. */
  readonly backend: Backend;
  /** Of the first view of the last frame. */
  readonly shading: Shading;
  /** Drawn in the last frame, after culling. */
  readonly triangles: number;
  /** Largest distance of straight edges from the curves that they approximate in the last frame [px]; more than requested if there would be too many patches. */
  readonly tolerance: number;
  /** Largest width and height of a picture on this device [px]. */
  readonly maxTextureSize: number;
  /** In the last frame, after culling. */
  readonly objectsDrawn: number;
  /** Of the scene. */
  readonly objects: number;
  /** Whether the last requested picture was not drawn because samples of a deforming mesh, or code that few pictures need, are being loaded. */
  readonly waiting: boolean;
  /** CPU time of the last `render` call [ms], without the GPU's. */
  readonly milliseconds: number;
}
