import {
  ClampToEdgeWrapping,
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  MirroredRepeatWrapping,
  NearestFilter,
  NoColorSpace,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
  UnsignedByteType,
} from 'three/webgpu';
import type { Texture, TextureWrap } from '../scene/types.ts';

const WRAPS = { repeat: RepeatWrapping, clamp: ClampToEdgeWrapping, mirror: MirroredRepeatWrapping } as const;
const wrap = (w: TextureWrap) => WRAPS[w];

/** An image on the GPU. Its rows run from the top, so it is read at 1 − v. */
export function uploadTexture(image: Texture): DataTexture {
  const pixels = new Uint8Array(image.data);
  const made = new DataTexture(pixels, image.width, image.height, RGBAFormat, UnsignedByteType);
  made.colorSpace = image.colorSpace === 'srgb' ? SRGBColorSpace : NoColorSpace;
  made.wrapS = wrap(image.wrapS);
  made.wrapT = wrap(image.wrapT);
  // Crisp texels near, and no moiré far away, whatever the file asks for.
  made.magFilter = image.filter === 'nearest' ? NearestFilter : LinearFilter;
  made.minFilter = LinearMipmapLinearFilter;
  made.generateMipmaps = true;
  made.anisotropy = image.filter === 'nearest' ? 1 : 8;
  made.needsUpdate = true;
  return made;
}
