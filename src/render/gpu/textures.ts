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

const dataIds = new WeakMap<object, number>();
let nextId = 0;

/** Equal for textures with the same texels and sampling: readers create one texture per material. */
export function textureKey({ data, colorSpace, filter, wrapS, wrapT }: Texture): string {
  const id = dataIds.get(data) ?? nextId++;
  dataIds.set(data, id);
  return `${id} ${colorSpace} ${filter} ${wrapS} ${wrapT}`;
}

/** Samples along the longer side of a pixel's footprint: a floor stays sharp far away. */
const ANISOTROPY = 8;

/**
 * Uploads an image. Its rows run from the top, so it is read at 1 − v. `anisotropic`: not where the processor draws, which takes more than twice
 * as long for a floor with it (llvmpipe).
 */
export function uploadTexture(image: Texture | RadianceTexture, anisotropic: boolean): DataTexture {
  const { data, width, height } = image;
  const type = data instanceof Uint16Array ? HalfFloatType : UnsignedByteType;
  // Not a copy, which would double the memory of a scene's pictures. Threads that share memory do not draw.
  const uploaded = new DataTexture(data as typeof data & ArrayBufferView<ArrayBuffer>, width, height, RGBAFormat, type);
  uploaded.colorSpace = image.colorSpace === 'srgb' ? SRGBColorSpace : NoColorSpace;
  uploaded.wrapS = wrap(image.wrapS);
  uploaded.wrapT = wrap(image.wrapT);
  // Sharp texels near by, and no moiré far away, whatever the file says.
  uploaded.magFilter = image.filter === 'nearest' ? NearestFilter : LinearFilter;
  uploaded.minFilter = LinearMipmapLinearFilter;
  uploaded.generateMipmaps = true;
  uploaded.anisotropy = anisotropic && image.filter !== 'nearest' ? ANISOTROPY : 1;
  uploaded.userData.ends = [image.wrapS === 'black' && image.width, image.wrapT === 'black' && image.height];
  uploaded.needsUpdate = true;
  return uploaded;
}

/** Samples an uploaded texture at `uv`; with black borders it fades over one texel, as interpolation between texels does. */
export function sampled(map: DataTexture, uv: Vec2): Vec4 {
  const ends: readonly (number | false)[] = map.userData.ends;
  const inside = ends.flatMap((size, k) => {
    if (size === false) return [];
    const at = k === 0 ? uv.x : uv.y;
    return [clamp(at.mul(size).add(0.5), 0, 1).mul(clamp(at.oneMinus().mul(size).add(0.5), 0, 1))];
  });
  return inside.reduce<Vec4>((color, weight) => color.mul(weight), texture(map, uv));
}
