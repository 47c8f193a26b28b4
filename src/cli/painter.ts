import type { Backend } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { CliError, EXIT, unavailable } from './exit.ts';
import type { AovData } from './pictures.ts';
import type { RenderFlags } from './render.ts';

export interface PictureRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** n × n samples per pixel. */
  readonly samples: number;
  /** The picture itself is wanted, for a screen. */
  readonly pixels: boolean;
  readonly aovs: readonly AovName[];
}

export interface Picture {
  /** sRGB, RGBA8, rows from the top; empty where it was not asked for. */
  readonly pixels: Uint8Array;
  readonly aovs: AovData;
}

/** What made the pictures, for `--json`. */
export type PainterInfo =
  | { readonly pipeline: 'raster'; readonly backend: Backend; readonly adapter: string }
  | { readonly pipeline: 'reference'; readonly threads: number; readonly seed: number };

/** A picture's scene, and those of its plan's other G-buffers. */
export type Scenes = readonly [Scene, ...Scene[]];

/** Makes pictures of one scene: here on a GPU, in a browser, or on the processor. */
export interface Painter {
  readonly info: PainterInfo;
  /** n × n samples per pixel where nobody says. */
  readonly usualSamples: number;
  /** `onPart` hears, now and then, which part of the picture is done, 0 … 1. */
  paint(request: PictureRequest, onPart?: (part: number) => void): Promise<Picture>;
  close(): Promise<void>;
}

/**
 * `auto`: WebGPU here; where there is no GPU for that, WebGL2 in a browser; where there is none either, the reference renderer,
 * unless a backend was asked for by name.
 */
export async function openPainter(
  path: string,
  scenes: Scenes,
  flags: RenderFlags,
  say: (text: string) => void,
): Promise<Painter> {
  const { pipeline, backend } = flags;
  if (pipeline === 'reference') return openReference(scenes, flags);
  const missing: string[] = [];
  for (const each of backend === 'auto' ? (['webgpu', 'webgl'] as const) : [backend]) {
    try {
      return await OPENERS[each](path, scenes, flags);
    } catch (error) {
      if (!(error instanceof CliError && error.exitCode === EXIT.unavailable)) throw error;
      missing.push(`${each}: ${error.message}`);
    }
  }
  if (pipeline === 'raster' || backend !== 'auto' || flags.solver !== 'exact') {
    throw unavailable(`${missing.join('\n')}\nWithout a GPU: --pipeline reference.`);
  }
  say(`slowlight: no usable GPU, so the reference renderer draws: slower, and exact.\n${missing.join('\n')}`);
  return openReference(scenes, flags);
}

/** Each is loaded when it is needed: they bring large libraries, and some machines cannot load them. */
const OPENERS: Record<Backend, (path: string, scenes: Scenes, flags: RenderFlags) => Promise<Painter>> = {
  webgpu: async (_, scenes, { size }) => (await import('./webgpu.ts')).openWebGpuPainter(scenes, size),
  webgl: async (path, [scene], flags) => (await import('./webgl.ts')).openWebGlPainter(path, scene, flags),
};

const openReference = async (scenes: Scenes, flags: RenderFlags): Promise<Painter> =>
  (await import('./reference.ts')).openReferencePainter(scenes, flags);
