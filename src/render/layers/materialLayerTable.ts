import { int, round } from 'three/tsl';
import type { DataTexture } from 'three/webgpu';
import type { Material, Texture, TextureChannel } from '../../scene/types.ts';
import type { Float, Vec4 } from '../../shaders/types.ts';
import type { SceneTextures } from '../gbuffer/sceneTextures.ts';
import { channelValue } from '../gbuffer/surface.ts';
import { vLife, vUv } from '../geometry/vertexStage.ts';
import type { FloatTable, TablePart } from '../gpu/floatTable.ts';
import { sampled } from '../gpu/textures.ts';

/** The channels of layers, in the order of their scales and biases in the table. */
const CHANNELS = [
  'specular',
  'clearcoat',
  'clearcoatRoughness',
  'transmission',
  'thickness',
  'film',
  'filmThickness',
  'sheenRoughness',
] as const;
type Channel = (typeof CHANNELS)[number];

/** A number of a layer: its value, or its texture. */
type Numbers = Readonly<Record<Channel, readonly [value: number, from: TextureChannel | undefined]>>;

const numbersOf = ({ specular, clearcoat, transmission, volume, iridescence, sheen }: Material): Numbers => ({
  specular: [specular?.factor ?? 1, specular?.factorTexture],
  clearcoat: [clearcoat?.factor ?? 0, clearcoat?.factorTexture],
  clearcoatRoughness: [clearcoat?.roughness ?? 0, clearcoat?.roughnessTexture],
  transmission: [transmission?.factor ?? 0, transmission?.factorTexture],
  // Of the volume's greatest.
  thickness: [1, volume?.thicknessTexture],
  film: [iridescence?.factor ?? 0, iridescence?.factorTexture],
  // Between the least and the greatest.
  filmThickness: [1, iridescence?.thicknessTexture],
  sheenRoughness: [sheen?.roughness ?? 0, sheen?.roughnessTexture],
});

/**
 * Vectors of layers, a texel each: (tint of F₀, thickness [m]), (strength of the varnish's normal map along u and v, refractive index, dispersion),
 * (attenuation colour, 1/attenuation distance [1/m]), (refractive index of the film, its least and greatest thickness [µm]), (colour of the fuzz), (strength of the grooves, cosine and sine of their rotation).
 */
const vectorsOf = ({
  specular,
  clearcoat,
  volume,
  iridescence,
  sheen,
  anisotropy,
  ior = 1.5,
  dispersion = 0,
}: Material): readonly number[] => [
  ...[...(specular?.color ?? [1, 1, 1]), volume?.thickness ?? 0],
  ...[...(clearcoat?.normalTexture?.strength ?? [0, 0]), ior, dispersion],
  ...[...(volume?.attenuationColor ?? [1, 1, 1]), 1 / (volume?.attenuationDistance ?? Number.POSITIVE_INFINITY)],
  ...[iridescence?.ior ?? 1, ...(iridescence?.thickness ?? [0, 0]).map((metres) => 1e6 * metres), 0],
  ...[...(sheen?.color ?? [0, 0, 0]), 0],
  ...[anisotropy?.strength ?? 0, Math.cos(anisotropy?.rotation ?? 0), Math.sin(anisotropy?.rotation ?? 0), 0],
];
const VECTOR_TEXELS = 6;
const LAYER_TEXELS = VECTOR_TEXELS + Math.ceil(CHANNELS.length / 2);

/** The layers of all materials, and their textures. */
export class MaterialLayerTable {
  private readonly part: TablePart;
  private readonly textures: SceneTextures;

  constructor(materials: readonly Material[], table: FloatTable, textures: SceneTextures) {
    this.textures = textures;
    this.part = table.part(materials.length * LAYER_TEXELS);
    materials.forEach((material, i) => {
      const linear = Object.values(numbersOf(material)).flatMap(([value, from]) =>
        from ? [from.scale, from.bias] : [0, value],
      );
      this.part.set([...vectorsOf(material), ...linear], LAYER_TEXELS * i);
    });
  }

  /** Reads the layers of a fragment's material; `like` has the textures of all materials that are drawn together. */
  reader(like: Material): LayerReader {
    const { part, textures } = this;
    const given = Object.entries(numbersOf(like)).flatMap(([name, [, from]]) => (from ? [[name, from]] : []));
    const channels = textures.channels<Channel>(Object.fromEntries(given));
    const texel = (k: number): Vec4 => part.texel(int(round(vLife.w)).mul(int(LAYER_TEXELS)).add(int(k)));
    return {
      vector: (k) => texel(k),
      number: (name) => {
        const k = CHANNELS.indexOf(name);
        const pair = texel(VECTOR_TEXELS + Math.floor(k / 2)).toVar();
        return channelValue(channels[name], k % 2 === 0 ? pair.xy : pair.zw).toVar();
      },
      texture: (picture) => textures.of(picture),
      sample: (picture) => sampled(textures.of(picture), vUv),
    };
  }
}

export interface LayerReader {
  vector(texel: number): Vec4;
  number(name: Channel): Float;
  texture(picture: Texture): DataTexture;
  /** The texel at the fragment. */
  sample(picture: Texture): Vec4;
}
