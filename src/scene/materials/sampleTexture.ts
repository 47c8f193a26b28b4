import { fromHalf } from '../../math/half.ts';
import type { RadianceTexture, Texture, TextureWrap } from '../types.ts';

export type Rgba = readonly [r: number, g: number, b: number, a: number];

/**
 * Samples a texture at (u, v), v up, from its base level. Returns linear RGB and opacity, 0 … 1, or radiance ≥ 0. Texels are decoded before interpolation, as
 * on GPUs; texel centres are at half-integers.
 */
export function sampleTexture(texture: Texture | RadianceTexture, u: number, v: number): Rgba {
  const x = u * texture.width;
  const y = (1 - v) * texture.height;
  if (texture.filter === 'nearest') return texel(texture, Math.floor(x), Math.floor(y));
  const left = Math.floor(x - 0.5);
  const top = Math.floor(y - 0.5);
  const [s, t] = [x - 0.5 - left, y - 0.5 - top];
  const above = blend(texel(texture, left, top), texel(texture, left + 1, top), s);
  const below = blend(texel(texture, left, top + 1), texel(texture, left + 1, top + 1), s);
  return blend(above, below, t);
}

const blend = (a: Rgba, b: Rgba, s: number): Rgba => [
  a[0] + (b[0] - a[0]) * s,
  a[1] + (b[1] - a[1]) * s,
  a[2] + (b[2] - a[2]) * s,
  a[3] + (b[3] - a[3]) * s,
];

function texel(texture: Texture | RadianceTexture, x: number, y: number): Rgba {
  const { width, height, data, colorSpace, wrapS, wrapT } = texture;
  const k = 4 * (wrapTexel(y, height, wrapT) * width + wrapTexel(x, width, wrapS));
  if (k < 0) return TRANSPARENT_BLACK;
  if (data instanceof Uint16Array)
    return [fromHalf(data[k]), fromHalf(data[k + 1]), fromHalf(data[k + 2]), fromHalf(data[k + 3])];
  const decoded = colorSpace === 'srgb' ? SRGB_DECODED : LINEAR;
  return [decoded[data[k]], decoded[data[k + 1]], decoded[data[k + 2]], LINEAR[data[k + 3]]];
}

/** The wrapped index of a row or column; −∞ outside a texture with wrap mode `black`. */
function wrapTexel(i: number, size: number, wrap: TextureWrap): number {
  if (wrap === 'black') return i >= 0 && i < size ? i : Number.NEGATIVE_INFINITY;
  if (wrap === 'clamp') return Math.min(Math.max(i, 0), size - 1);
  const period = wrap === 'mirror' ? 2 * size : size;
  const inside = i - period * Math.floor(i / period);
  return inside < size ? inside : period - 1 - inside;
}

const TRANSPARENT_BLACK: Rgba = [0, 0, 0, 0];
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => byte / 255);
/** Encoded sRGB → linear light. Source: IEC 61966-2-1. */
const SRGB_DECODED = LINEAR.map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));

/** The linear value of each byte, or of each half by its bits. */
export function linearizationTable({ data, colorSpace }: Texture | RadianceTexture): ArrayLike<number> {
  if (data instanceof Uint16Array) return Float32Array.from({ length: 2 ** 16 }, (_, bits) => fromHalf(bits));
  return colorSpace === 'srgb' ? SRGB_DECODED : LINEAR;
}
