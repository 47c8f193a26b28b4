import { FloatType, NearestFilter, NoColorSpace, RedFormat, RenderTarget } from 'three/webgpu';

/** One number per texel, read as it is. */
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
