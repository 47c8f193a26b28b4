import type { Backend } from '../../render/settings.ts';

/** Whether this browser can draw at all, with what was asked for. */
export async function hasGraphics(backend: Backend | 'auto'): Promise<boolean> {
  if (backend !== 'webgpu' && hasWebGl2()) return true;
  return backend !== 'webgl' && hasWebGpu();
}

const hasWebGl2 = (): boolean => document.createElement('canvas').getContext('webgl2') !== null;

async function hasWebGpu(): Promise<boolean> {
  try {
    // Absent on pages that are not secure, whatever its type says.
    const gpu: GPU | undefined = navigator.gpu;
    return Boolean(await gpu?.requestAdapter());
  } catch {
    return false;
  }
}
