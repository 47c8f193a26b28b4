import { lerp, scale, type Vec3 } from '../../../math/vec3.ts';
import type { Material, Texture, TextureChannel } from '../../../scene/types.ts';
import { decodeSrgb, encodeSrgb } from '../../../spectrum/display/srgb.ts';
import { channelMean } from '../../image/imageChannels.ts';

/** F₀ of a dielectric. */
const DIELECTRIC = 0.04;
const EPSILON = 1e-6;

/** A surface by what it scatters and what it reflects at normal incidence, linear sRGB. */
export interface SpecularGlossiness {
  readonly diffuse: Vec3;
  readonly specular: Vec3;
}

/**
 * The same surface by base colour and metalness, as the appendix of `KHR_materials_pbrSpecularGlossiness` converts it: metalness m solves
 * 0.04 m² + (d(1 − s)/0.96 + r − 0.08) m + 0.04 − r = 0, d and r the perceived brightness of both, s the largest channel of `specular`.
 */
export function metallicOf({ diffuse, specular }: SpecularGlossiness): { baseColor: Vec3; metallic: number } {
  const rest = (1 - Math.max(...specular)) / (1 - DIELECTRIC);
  const reflected = brightness(specular);
  const b = brightness(diffuse) * rest + reflected - 2 * DIELECTRIC;
  const root = (-b + Math.sqrt(Math.max(b * b - 4 * DIELECTRIC * (DIELECTRIC - reflected), 0))) / (2 * DIELECTRIC);
  const metallic = reflected < DIELECTRIC ? 0 : Math.min(Math.max(root, 0), 1);
  const ofDiffuse = scale(diffuse, rest / Math.max(1 - metallic, EPSILON));
  const metal = (x: number): number => (x - DIELECTRIC * (1 - metallic)) / Math.max(metallic, EPSILON);
  const [r, g, b2] = lerp(ofDiffuse, [metal(specular[0]), metal(specular[1]), metal(specular[2])], metallic ** 2);
  return { baseColor: [unit(r), unit(g), unit(b2)], metallic };
}

const unit = (x: number): number => Math.min(Math.max(x, 0), 1);
const brightness = ([r, g, b]: Vec3): number => Math.sqrt(0.299 * r * r + 0.587 * g * g + 0.114 * b * b);

/** Factors and textures of the extension; `specular` has glossiness in its alpha. */
export interface SpecularGlossinessSource extends SpecularGlossiness {
  readonly glossiness: number;
  readonly diffuseTexture?: Texture;
  readonly specularTexture?: Texture;
}

/** Our material of them; textures are converted texel by texel, at the size of the larger one. */
export function fromSpecularGlossiness(
  source: SpecularGlossinessSource,
): Pick<
  Material,
  'baseColor' | 'baseColorTexture' | 'metallic' | 'metallicTexture' | 'roughness' | 'roughnessTexture'
> {
  const { diffuse, specular, glossiness, diffuseTexture, specularTexture } = source;
  const roughness = 1 - glossiness;
  if (!diffuseTexture && !specularTexture) return { ...metallicOf({ diffuse, specular }), roughness };
  const { color, finish } = converted(source);
  const channel = (k: 1 | 2): TextureChannel => ({ texture: finish, channel: k, scale: 1, bias: 0 });
  return {
    baseColor: [1, 1, 1],
    baseColorTexture: color,
    metallic: channelMean(finish, 2),
    metallicTexture: channel(2),
    roughness: channelMean(finish, 1),
    roughnessTexture: channel(1),
  };
}

const DECODED = Float64Array.from({ length: 256 }, (_, byte) => decodeSrgb(byte / 255));
const WHITE = [255, 255, 255, 255];

/** Base colour with opacity, sRGB; and a texture with roughness in green and metalness in blue. */
function converted(source: SpecularGlossinessSource): { readonly color: Texture; readonly finish: Texture } {
  const { diffuse, specular, glossiness, diffuseTexture, specularTexture } = source;
  const like = [diffuseTexture, specularTexture]
    .flatMap((one) => one ?? [])
    .reduce((a, b) => (b.data.length > a.data.length ? b : a));
  const { width, height } = like;
  const [color, finish] = [new Uint8Array(4 * width * height), new Uint8Array(4 * width * height).fill(255)];
  const texel = (of: Texture | undefined, x: number, y: number): ArrayLike<number> => {
    if (!of) return WHITE;
    const row = Math.floor((y * of.height) / height);
    const at = 4 * (row * of.width + Math.floor((x * of.width) / width));
    return of.data.subarray(at, at + 4);
  };
  const tinted = ([r, g, b]: Vec3, t: ArrayLike<number>): Vec3 => [
    r * DECODED[t[0]],
    g * DECODED[t[1]],
    b * DECODED[t[2]],
  ];
  for (let y = 0, at = 0; y < height; y++)
    for (let x = 0; x < width; x++, at += 4) {
      const [d, s] = [texel(diffuseTexture, x, y), texel(specularTexture, x, y)];
      const { baseColor, metallic } = metallicOf({ diffuse: tinted(diffuse, d), specular: tinted(specular, s) });
      for (let k = 0; k < 3; k++) color[at + k] = Math.round(255 * encodeSrgb(baseColor[k]));
      color[at + 3] = d[3];
      finish[at + 1] = Math.round(255 - glossiness * s[3]);
      finish[at + 2] = Math.round(255 * metallic);
    }
  const { name } = like;
  return {
    color: { ...like, name: `${name} (base colour)`, data: color, colorSpace: 'srgb' },
    finish: { ...like, name: `${name} (metal and roughness)`, data: finish, colorSpace: 'linear' },
  };
}
