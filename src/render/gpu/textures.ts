import { clamp, texture } from 'three/tsl';
import {
  ClampToEdgeWrapping,
  DataTexture,
  HalfFloatType,
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
import type { RadianceTexture, Texture, TextureWrap } from '../../scene/types.ts';
import type { Vec2, Vec4 } from '../../shaders/types.ts';

const WRAPS = {
  repeat: RepeatWrapping,
  clamp: ClampToEdgeWrapping,
  mirror: MirroredRepeatWrapping,
  black: ClampToEdgeWrapping,
} as const;
const wrap = (w: TextureWrap) => WRAPS[w];

const numbers = new WeakMap<object, number>();
let numbered = 0;

/** The same for textures that show the same picture in the same way: readers make one for each material. */
export function textureKey({ data, colorSpace, filter, wrapS, wrapT }: Texture): string {
  const number = numbers.get(data) ?? numbered++;
  numbers.set(data, number);
  return `${number} ${colorSpace} ${filter} ${wrapS} ${wrapT}`;
}

/** An image on the GPU. Its rows run from the top, so it is read at 1 − v. */
export function uploadTexture(image: Texture | RadianceTexture): DataTexture {
  const { data, width, height } = image;
  const made =
    data instanceof Uint16Array
      ? new DataTexture(new Uint16Array(data), width, height, RGBAFormat, HalfFloatType)
      : new DataTexture(new Uint8Array(data), width, height, RGBAFormat, UnsignedByteType);
  made.colorSpace = image.colorSpace === 'srgb' ? SRGBColorSpace : NoColorSpace;
  made.wrapS = wrap(image.wrapS);
  made.wrapT = wrap(image.wrapT);
  // Crisp texels near, and no moiré far away, whatever the file asks for.
  made.magFilter = image.filter === 'nearest' ? NearestFilter : LinearFilter;
  made.minFilter = LinearMipmapLinearFilter;
  made.generateMipmaps = true;
  made.anisotropy = image.filter === 'nearest' ? 1 : 8;
  made.userData.ends = [image.wrapS === 'black' && image.width, image.wrapT === 'black' && image.height];
  made.needsUpdate = true;
  return made;
}

/** A texture that was uploaded, at `uv`: where it ends in black it fades over a texel, as what is blended between texels does. */
export function sampled(map: DataTexture, uv: Vec2): Vec4 {
  const ends: readonly (number | false)[] = map.userData.ends;
  const inside = ends.flatMap((size, k) => {
    if (size === false) return [];
    const at = k === 0 ? uv.x : uv.y;
    return [clamp(at.mul(size).add(0.5), 0, 1).mul(clamp(at.oneMinus().mul(size).add(0.5), 0, 1))];
  });
  return inside.reduce<Vec4>((color, share) => color.mul(share), texture(map, uv));
}
