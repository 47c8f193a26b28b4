import { PictureTooLargeError } from '../../nodes/pictures/maxSize.ts';
import type { PictureRenderer } from '../../nodes/pictures/pictureRenderer.ts';
import type { Backend } from '../../render/settings.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderFlags } from '../render/renderFlags.ts';
import { CliError, EXIT, unavailable } from '../terminal/exitCodes.ts';

/** What made the pictures, for `--json`. */
export type PipelineInfo =
  | { readonly pipeline: 'raster'; readonly backend: Backend; readonly adapter: string }
  | { readonly pipeline: 'reference'; readonly threads: number; readonly seed: number };

/** A picture's scene, and those of its plan's other G-buffers. */
export type PictureScenes = readonly [Scene, ...Scene[]];

/** Here on a GPU, in a browser, or on the processor. */
export interface RendererSession extends PictureRenderer {
  readonly info: PipelineInfo;
  close(): Promise<void>;
}

/**
 * `auto`: WebGPU here; where there is no GPU for that, WebGL2 in a browser; where there is none either, the reference renderer,
 * unless a backend was asked for by name.
 */
export async function openRenderer(
  scenes: PictureScenes,
  flags: RenderFlags,
  say: (text: string) => void,
): Promise<RendererSession> {
  const { pipeline, backend } = flags;
  if (pipeline === 'reference') return openReferenceRenderer(scenes, flags);
  const missing: string[] = [];
  for (const each of backend === 'auto' ? (['webgpu', 'webgl'] as const) : [backend]) {
    try {
      return await OPENERS[each](scenes, flags);
    } catch (error) {
      if (!isUnavailable(error)) throw error;
      missing.push(`${each}: ${error.message}`);
    }
  }
  if (pipeline === 'raster' || backend !== 'auto' || flags.solver !== 'exact') {
    throw unavailable(`${missing.join('\n')}\nWithout a GPU: --pipeline reference.`);
  }
  say(`slowlight: no usable GPU, so the reference renderer draws: slower, and exact.\n${missing.join('\n')}`);
  return openReferenceRenderer(scenes, flags);
}

/** What another way of drawing may have. */
const isUnavailable = (error: unknown): error is Error =>
  error instanceof PictureTooLargeError || (error instanceof CliError && error.exitCode === EXIT.unavailable);

/** Each is loaded when it is needed: they bring large libraries, and some machines cannot load them. */
const OPENERS: Record<Backend, (scenes: PictureScenes, flags: RenderFlags) => Promise<RendererSession>> = {
  webgpu: async (scenes, { size }) => (await import('./webgpuRenderer.ts')).openWebGpuRenderer(scenes, size),
  webgl: async (scenes, { size }) => (await import('./webglRenderer.ts')).openWebGlRenderer(scenes, size),
};

const openReferenceRenderer = async (scenes: PictureScenes, flags: RenderFlags): Promise<RendererSession> =>
  (await import('./referenceRenderer.ts')).openReferenceRenderer(scenes, flags);
