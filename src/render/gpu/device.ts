import { LinearSRGBColorSpace, NoToneMapping, WebGPURenderer } from 'three/webgpu';
import type { Backend, RendererOptions } from '../settings.ts';
import { RAISED_LIMITS } from './deviceLimits.ts';
import { isSoftwareGpu, webglRendererName } from './softwareGpu.ts';

/** Three's renderer, and the device limits that decide how passes are laid out. */
export interface Gpu {
  readonly renderer: WebGPURenderer;
  readonly backend: Backend;
  readonly maxBytesPerSample: number;
  readonly maxAttachments: number;
  /** Largest width and height of textures [px]. */
  readonly maxTextureSize: number;
  /** Whether 32-bit float targets can be blended into. */
  readonly floatBlending: boolean;
  /** Whether the processor draws. */
  readonly software: boolean;
}

type Adapter = Awaited<ReturnType<GPU['requestAdapter']>>;

export async function openGpu(options: RendererOptions): Promise<Gpu> {
  const requestedBackend = options.backend ?? 'auto';
  const adapter = options.device || requestedBackend === 'webgl' ? null : await findAdapter();
  if (requestedBackend === 'webgpu' && !options.device && !adapter)
    throw new Error('WebGPU: this machine has no adapter for it');
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
  // The last pass encodes for the display itself.
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.toneMapping = NoToneMapping;
  renderer.setClearColor(0, 0);
  renderer.setPixelRatio(1);
  return { renderer, ...capabilities(renderer) };
}

async function findAdapter(): Promise<Adapter> {
  if (typeof navigator === 'undefined' || !navigator.gpu) return null;
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: 'high-performance' });
  // Three.js draws nothing right on a reduced "compatibility" adapter; WebGL2 works there.
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
      software: isSoftwareAdapter(device.adapterInfo),
    };
  }
  const gl = renderer.getContext() as WebGL2RenderingContext;
  return {
    backend: 'webgl',
    maxBytesPerSample: Number.POSITIVE_INFINITY,
    maxAttachments: gl.getParameter(gl.MAX_DRAW_BUFFERS),
    maxTextureSize: gl.getParameter(gl.MAX_TEXTURE_SIZE),
    floatBlending: gl.getExtension('EXT_float_blend') !== null,
    software: isSoftwareGpu(webglRendererName(gl)),
  };
}

/** Older browsers do not tell of a device's adapter. */
const isSoftwareAdapter = (info: GPUAdapterInfo | undefined): boolean =>
  info !== undefined && (info.isFallbackAdapter || isSoftwareGpu(`${info.description} ${info.architecture}`));

function watchLoss(renderer: WebGPURenderer, onLost: RendererOptions['onLost']): void {
  const stopDrawing = renderer.onDeviceLost;
  let notified = false;
  renderer.onDeviceLost = (info) => {
    stopDrawing.call(renderer, info);
    if (!notified) onLost?.(info.message);
    notified = true;
  };
}

/** Stands in for the canvas if there is none; three.js still asks it for its size. */
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
