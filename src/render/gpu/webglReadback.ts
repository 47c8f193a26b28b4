import type { Texture, WebGPURenderer } from 'three/webgpu';
import type { PixelRect } from '../../scene/view/pictureViews.ts';

/** Values of pixels as they are stored. */
export type RawPixels = Float32Array | Uint16Array | Uint8Array;

/** What three's backend knows of a texture; three has no public way to it. */
interface WebGlTexture {
  readonly textureGPU: WebGLTexture;
  readonly glFormat: number;
  readonly glType: number;
}

/** Interval at which the fence is polled [ms]. */
const POLL_INTERVAL = 4;

/**
 * Reads a region of a texture by WebGL, counted from the bottom, without blocking the page. `getBufferSubData` waits for
 * all commands so far, so it is called as soon as the copy is there; three's own reading calls it in an animation frame,
 * after the next picture has been asked for, and waits for that (0.3 s of the main thread on a software GPU).
 */
export async function readWebGl(renderer: WebGPURenderer, texture: Texture, region: PixelRect): Promise<RawPixels> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const backend = renderer.backend as unknown as { get(texture: Texture): WebGlTexture };
  const { textureGPU, glFormat, glType } = backend.get(texture);
  const { x, y, width, height } = region;
  const pixels = pixelArray(gl, glType, width * height * channelsOf(gl, glFormat));
  const buffer = gl.createBuffer();
  const framebuffer = gl.createFramebuffer();
  const bound = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, textureGPU, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, pixels.byteLength, gl.STREAM_READ);
  gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
  gl.readPixels(x, y, width, height, glFormat, glType, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound);
  gl.deleteFramebuffer(framebuffer);
  try {
    await commandsFinished(gl);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixels);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  } finally {
    gl.deleteBuffer(buffer);
  }
  return pixels;
}

/** Resolves when all commands so far have been executed. Throws if the context is lost. */
async function commandsFinished(gl: WebGL2RenderingContext): Promise<void> {
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  do {
    await new Promise((resolve) => setTimeout(resolve, POLL_INTERVAL));
    if (!sync || gl.isContextLost()) throw new Error('WebGL: the context is lost');
  } while (gl.getSyncParameter(sync, gl.SYNC_STATUS) !== gl.SIGNALED);
  gl.deleteSync(sync);
}

function pixelArray(gl: WebGL2RenderingContext, type: number, length: number): RawPixels {
  if (type === gl.FLOAT) return new Float32Array(length);
  if (type === gl.HALF_FLOAT) return new Uint16Array(length);
  if (type === gl.UNSIGNED_BYTE) return new Uint8Array(length);
  throw new Error(`WebGL: pixels of type ${type} are not read`);
}

function channelsOf(gl: WebGL2RenderingContext, format: number): number {
  if (format === gl.RGBA) return 4;
  if (format === gl.RG) return 2;
  if (format === gl.RED) return 1;
  throw new Error(`WebGL: pixels of format ${format} are not read`);
}
