import type { Backend } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import { CliError, EXIT } from './exit.ts';
import type { Size } from './parse.ts';
import type { AovData } from './pictures.ts';

export interface PictureRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  readonly samples: number;
  readonly aovs: readonly AovName[];
}

export interface Picture {
  /** sRGB, RGBA8, rows from the top. */
  readonly pixels: Uint8Array;
  readonly aovs: AovData;
}

/** Makes pictures of one scene, here or in a browser. */
export interface Painter {
  readonly backend: Backend;
  readonly adapterName: string;
  paint(request: PictureRequest): Promise<Picture>;
  close(): Promise<void>;
}

/** `auto`: WebGPU here, and where there is no GPU for that, WebGL2 in a browser. */
export async function openPainter(backend: Backend | 'auto', path: string, scene: Scene, size: Size): Promise<Painter> {
  const openWebGl = async (): Promise<Painter> => (await import('./webgl.ts')).openWebGlPainter(path, size);
  if (backend === 'webgl') return openWebGl();
  try {
    return await (await import('./webgpu.ts')).openWebGpuPainter(scene, size);
  } catch (error) {
    if (backend === 'webgpu' || !(error instanceof CliError && error.exitCode === EXIT.unavailable)) throw error;
    return openWebGl();
  }
}
