import { FloatType, NearestFilter, NoColorSpace, RedFormat, RenderTarget } from 'three/webgpu';

/** A render target with one 32-bit float per texel, read without filtering. */
export const shadowAtlasTarget = (depthBuffer: boolean): RenderTarget =>
  new RenderTarget(1, 1, {
    type: FloatType,
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer,
    colorSpace: NoColorSpace,
  });
