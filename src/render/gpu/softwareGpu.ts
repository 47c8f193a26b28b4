/**
 * Whether a GPU's name is that of a driver that draws on the processor.
 * @example
 * isSoftwareGpu('llvmpipe (LLVM 15.0.7, 256 bits)'); // true
 */
export const isSoftwareGpu = (name: string): boolean =>
  /swiftshader|llvmpipe|lavapipe|softpipe|software|basic render/i.test(name);

/** What a WebGL context tells of its renderer. */
export function webglRendererName(gl: WebGL2RenderingContext): string {
  const name = gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL;
  return String(gl.getParameter(name ?? gl.RENDERER));
}
