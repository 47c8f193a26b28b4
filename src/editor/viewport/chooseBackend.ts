import { isSoftwareGpu, webglRendererName } from '../../render/gpu/softwareGpu.ts';
import type { Backend } from '../../render/settings.ts';

/**
 * The backend: the requested one if available, undefined if none is. With `auto`, a software WebGPU adapter is rejected
 * in favour of WebGL2, which is several times as fast there.
 */
export async function chooseBackend(wanted: Backend | 'auto'): Promise<Backend | 'auto' | undefined> {
  if (wanted === 'webgl') return hasWebGl2() ? 'webgl' : undefined;
  const adapter = await findAdapter();
  if (wanted === 'webgpu') return adapter ? 'webgpu' : undefined;
  if (adapter && !adapter.info.isFallbackAdapter) return 'auto';
  if (!hasWebGl2()) return adapter ? 'auto' : undefined;
  return adapter ? 'webgl' : 'auto';
}

/** Whether the renderer runs on the CPU, as far as the browser reports it. */
export function isSoftwareRenderer(): boolean {
  const gl = tried ?? tryWebGl2();
  tried = undefined;
  if (!gl) return false;
  const name = webglRendererName(gl);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return isSoftwareGpu(name);
}

/** The context that `chooseBackend` tried: making one takes 0.1 s without a GPU. Used once, because it may be lost later. */
let tried: WebGL2RenderingContext | undefined;

const tryWebGl2 = (): WebGL2RenderingContext | undefined =>
  document.createElement('canvas').getContext('webgl2') ?? undefined;

function hasWebGl2(): boolean {
  tried ??= tryWebGl2();
  return tried !== undefined;
}

async function findAdapter(): Promise<GPUAdapter | undefined> {
  try {
    // Missing on insecure pages, despite its type.
    const gpu: GPU | undefined = navigator.gpu;
    return (await gpu?.requestAdapter()) ?? undefined;
  } catch {
    return undefined;
  }
}
