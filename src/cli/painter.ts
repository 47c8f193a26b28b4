import { PictureTooLarge } from '../nodes/drawing/largest.ts';
import type { PicturePainter } from '../nodes/drawing/painter.ts';
import type { Backend } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import { CliError, EXIT, unavailable } from './exit.ts';
import type { RenderFlags } from './render.ts';

/** What made the pictures, for `--json`. */
export type PainterInfo =
  | { readonly pipeline: 'raster'; readonly backend: Backend; readonly adapter: string }
  | { readonly pipeline: 'reference'; readonly threads: number; readonly seed: number };

/** A picture's scene, and those of its plan's other G-buffers. */
export type Scenes = readonly [Scene, ...Scene[]];

/** Here on a GPU, in a browser, or on the processor. */
export interface Painter extends PicturePainter {
  readonly info: PainterInfo;
  close(): Promise<void>;
}

/**
 * `auto`: WebGPU here; where there is no GPU for that, WebGL2 in a browser; where there is none either, the reference renderer,
 * unless a backend was asked for by name.
 */
export async function openPainter(scenes: Scenes, flags: RenderFlags, say: (text: string) => void): Promise<Painter> {
  const { pipeline, backend } = flags;
  if (pipeline === 'reference') return openReference(scenes, flags);
  const missing: string[] = [];
  for (const each of backend === 'auto' ? (['webgpu', 'webgl'] as const) : [backend]) {
    try {
      return await OPENERS[each](scenes, flags);
    } catch (error) {
      if (!isLack(error)) throw error;
      missing.push(`${each}: ${error.message}`);
    }
  }
  if (pipeline === 'raster' || backend !== 'auto' || flags.solver !== 'exact') {
    throw unavailable(`${missing.join('\n')}\nWithout a GPU: --pipeline reference.`);
  }
  say(`slowlight: no usable GPU, so the reference renderer draws: slower, and exact.\n${missing.join('\n')}`);
  return openReference(scenes, flags);
}

/** What another way of drawing may have. */
const isLack = (error: unknown): error is Error =>
  error instanceof PictureTooLarge || (error instanceof CliError && error.exitCode === EXIT.unavailable);

/** Each is loaded when it is needed: they bring large libraries, and some machines cannot load them. */
const OPENERS: Record<Backend, (scenes: Scenes, flags: RenderFlags) => Promise<Painter>> = {
  webgpu: async (scenes, { size }) => (await import('./webgpu.ts')).openWebGpuPainter(scenes, size),
  webgl: async (scenes, { size }) => (await import('./webgl.ts')).openWebGlPainter(scenes, size),
};

const openReference = async (scenes: Scenes, flags: RenderFlags): Promise<Painter> =>
  (await import('./reference.ts')).openReferencePainter(scenes, flags);
