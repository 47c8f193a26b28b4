import { isSoftwareGpu, webglRendererName } from '../../render/gpu/softwareGpu.ts';
import type { Backend } from '../../render/settings.ts';

/**
 * The backend: the requested one if available, undefined if none is. With `auto`, a software WebGPU adapter is rejected
 * in favour of WebGL2, which is several times as fast there.
 */
export async function chooseBackend(wanted: Backend | 'auto'): Promise<Backend | 'auto' | undefined> {
  const webgl = hasWebGl2();
  if (wanted === 'webgl') return webgl ? 'webgl' : undefined;
  const adapter = await findAdapter();
  if (wanted === 'webgpu') return adapter ? 'webgpu' : undefined;
  if (!adapter && !webgl) return undefined;
  return adapter?.info.isFallbackAdapter && webgl ? 'webgl' : 'auto';
}

/** Whether the renderer runs on the CPU, as far as the browser reports it. */
export function isSoftwareRenderer(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const name = webglRendererName(gl);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return isSoftwareGpu(name);
}

const hasWebGl2 = (): boolean => document.createElement('canvas').getContext('webgl2') !== null;

async function findAdapter(): Promise<GPUAdapter | undefined> {
  try {
    // Missing on insecure pages, despite its type.
    const gpu: GPU | undefined = navigator.gpu;
    return (await gpu?.requestAdapter()) ?? undefined;
  } catch {
    return undefined;
  }
}
