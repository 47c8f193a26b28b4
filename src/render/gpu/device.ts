import { LinearSRGBColorSpace, NoToneMapping, WebGPURenderer } from 'three/webgpu';
import type { Backend, RendererOptions } from '../settings.ts';
import { RAISED_LIMITS } from './deviceLimits.ts';

/** three's renderer, and what of its device decides how the passes are laid out. */
export interface Gpu {
  readonly renderer: WebGPURenderer;
  readonly backend: Backend;
  readonly maxBytesPerSample: number;
  readonly maxAttachments: number;
  /** Width and height that textures can have [px]. */
  readonly maxTextureSize: number;
  /** Whether 32-bit float targets can be blended into. */
  readonly floatBlending: boolean;
}

type Adapter = Awaited<ReturnType<GPU['requestAdapter']>>;

export async function openGpu(options: RendererOptions): Promise<Gpu> {
  const wanted = options.backend ?? 'auto';
  const adapter = options.device || wanted === 'webgl' ? null : await findAdapter();
  if (wanted === 'webgpu' && !options.device && !adapter) throw new Error('WebGPU: this machine has no adapter for it');
  const webgl = !options.device && !adapter;
  const renderer = new WebGPURenderer({
    canvas: options.canvas ?? offscreenCanvas(),
    antialias: false,
    alpha: false,
    depth: false,
    reversedDepthBuffer: true,
    forceWebGL: webgl,
    powerPreference: 'high-performance',
    ...(options.device ? { device: options.device } : {}),
    ...(adapter
      ? { requiredLimits: Object.fromEntries(RAISED_LIMITS.map((name) => [name, adapter.limits[name]])) }
      : {}),
  });
  watchLoss(renderer, options.onLost);
  await renderer.init();
  // The last pass encodes for the screen itself.
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.toneMapping = NoToneMapping;
  renderer.setClearColor(0, 0);
  renderer.setPixelRatio(1);
  return { renderer, ...capabilities(renderer) };
}

async function findAdapter(): Promise<Adapter> {
  if (typeof navigator === 'undefined' || !navigator.gpu) return null;
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: 'high-performance' });
  // three draws nothing right on the reduced "compatibility" level; WebGL2 does.
  return adapter?.features.has('core-features-and-limits') === false ? null : adapter;
}

function capabilities(renderer: WebGPURenderer): Omit<Gpu, 'renderer'> {
  const { backend } = renderer;
  if ('device' in backend) {
    const device = backend.device as GPUDevice;
    return {
      backend: 'webgpu',
      maxBytesPerSample: device.limits.maxColorAttachmentBytesPerSample,
      maxAttachments: device.limits.maxColorAttachments,
      maxTextureSize: device.limits.maxTextureDimension2D,
      floatBlending: device.features.has('float32-blendable'),
    };
  }
  const gl = renderer.getContext() as WebGL2RenderingContext;
  return {
    backend: 'webgl',
    maxBytesPerSample: Number.POSITIVE_INFINITY,
    maxAttachments: gl.getParameter(gl.MAX_DRAW_BUFFERS),
    maxTextureSize: gl.getParameter(gl.MAX_TEXTURE_SIZE),
    floatBlending: gl.getExtension('EXT_float_blend') !== null,
  };
}

function watchLoss(renderer: WebGPURenderer, onLost: RendererOptions['onLost']): void {
  const stopDrawing = renderer.onDeviceLost;
  let told = false;
  renderer.onDeviceLost = (info) => {
    stopDrawing.call(renderer, info);
    if (!told) onLost?.(info.message);
    told = true;
  };
}

/** Where there is no canvas nothing is shown; three still asks one for its size. */
function offscreenCanvas(): HTMLCanvasElement {
  const stub = {
    width: 1,
    height: 1,
    style: {},
    addEventListener() {},
    removeEventListener() {},
    getContext() {
      throw new Error('this renderer was made without a canvas');
    },
  };
  return stub as unknown as HTMLCanvasElement;
}
