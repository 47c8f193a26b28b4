import type { Material as GltfMaterial, Texture as GltfTexture, TextureInfo } from '@gltf-transform/core';
import type { EmissiveStrength, IOR, PBRSpecularGlossiness, Transform } from '@gltf-transform/extensions';
import { scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import { inEnglish, type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import {
  InputError,
  type Material,
  type NormalTexture,
  type Texture,
  type TextureChannel,
  type TextureWrap,
} from '../../../scene/types.ts';
import { INVISIBLE_BANDS, parseSpectralHints } from '../../attributes/hints.ts';
import { type DecodedImage, decodeImage } from '../../image/decodeImage.ts';
import { channelMean } from '../../image/imageChannels.ts';
import { clampNormalStrength } from '../../read/limits.ts';
import type { GltfContext } from '../context.ts';
import { layersOf, layerTextures, type TextureInputs } from './materialLayers.ts';
import { fromSpecularGlossiness } from './specularGlossiness.ts';

/** How uv coordinates of a primitive are made for its material: (u, v) → offset + rotation · scale · (u, v), v down. */
export interface GltfUvSource {
  /** TEXCOORD set. */
  readonly set: number;
  readonly offset: readonly number[];
  /** [rad], as KHR_texture_transform counts it. */
  readonly rotation: number;
  readonly scale: readonly number[];
}

/** Materials of a file in order of use; images are decoded once. */
export class GltfMaterialLibrary {
  readonly materials: Material[] = [];
  private readonly context: GltfContext;
  private readonly places = [new Map<GltfMaterial | null, number>(), new Map<GltfMaterial | null, number>()] as const;
  private readonly images = new Map<GltfTexture, DecodedImage | undefined>();
  private readonly reader: TextureInputs = {
    color: (image, info) => this.texture(image, info, true),
    data: (image, info) => this.texture(image, info, true, 'linear'),
    number: (image, info, channel, scale) => {
      const texture = this.texture(image, info, false, 'linear');
      return texture && { texture, channel, scale, bias: 0 };
    },
    normal: (image, info, scale) => {
      const texture = this.texture(image, info, true, 'linear');
      const strength = clampNormalStrength(scale);
      return texture && { texture, strength: [strength, strength] };
    },
  };

  constructor(context: GltfContext) {
    this.context = context;
  }

  /** Index of a material in `materials`; null is glTF's default material. `unlit`: as one that emits its colour. */
  placeOf(material: GltfMaterial | null, unlit = false): number {
    const isUnlit = unlit || material?.getExtension('KHR_materials_unlit') != null;
    const places = this.places[isUnlit ? 1 : 0];
    const known = places.get(material);
    if (known !== undefined) return known;
    const place = this.materials.length;
    places.set(material, place);
    const byDefault = isUnlit ? UNLIT_DEFAULT : DEFAULT_MATERIAL;
    this.materials.push(material ? this.convert(material, isUnlit) : byDefault);
    return place;
  }

  /** Unlit surfaces emit their colour and reflect nothing. */
  private convert(material: GltfMaterial, isUnlit: boolean): Material {
    const name = nameOf(this.context, material);
    const glossy = material.getExtension<PBRSpecularGlossiness>('KHR_materials_pbrSpecularGlossiness');
    const [r, g, b, alpha] = glossy?.getDiffuseFactor() ?? material.getBaseColorFactor();
    const mode = material.getAlphaMode();
    const strength = material.getExtension<EmissiveStrength>('KHR_materials_emissive_strength');
    const ior = material.getExtension<IOR>('KHR_materials_ior');
    const baseColor: Vec3 = [r, g, b];
    const baseColorTexture = this.texture(
      ...(glossy
        ? ([glossy.getDiffuseTexture(), glossy.getDiffuseTextureInfo()] as const)
        : ([material.getBaseColorTexture(), material.getBaseColorTextureInfo()] as const)),
      mode === 'OPAQUE',
    );
    const emissive = scale(material.getEmissiveFactor(), strength?.getEmissiveStrength() ?? 1);
    const emissiveTexture = this.texture(material.getEmissiveTexture(), material.getEmissiveTextureInfo(), true);
    const light = isUnlit ? { emissive: baseColor, emissiveTexture: baseColorTexture } : { emissive, emissiveTexture };
    const layers = isUnlit ? UNLIT : layersOf(material, this.reader);
    return {
      name,
      baseColor: isUnlit ? ZERO : baseColor,
      ...(baseColorTexture && { baseColorTexture }),
      emissive: light.emissive,
      ...(light.emissiveTexture && { emissiveTexture: light.emissiveTexture }),
      ...(glossy && !isUnlit ? this.glossy(glossy, baseColorTexture) : this.finish(material, isUnlit)),
      ...this.normals(material),
      ...this.occlusion(material),
      opacity: mode === 'OPAQUE' ? 1 : alpha,
      opacityThreshold: mode === 'MASK' ? material.getAlphaCutoff() : 0,
      ...(ior && { ior: ior.getIOR() }),
      ...layers,
      ...this.spectral(material, name),
    };
  }

  /** Roughness is in the green channel, metalness in the blue. */
  private finish(material: GltfMaterial, isUnlit: boolean): MetallicRoughness {
    const [roughness, metallic] = [material.getRoughnessFactor(), material.getMetallicFactor()];
    if (isUnlit) return { roughness, metallic: 0 };
    const info = material.getMetallicRoughnessTextureInfo();
    const texture = this.texture(material.getMetallicRoughnessTexture(), info, false, 'linear');
    if (!texture) return { roughness, metallic };
    const channel = (channel: 1 | 2, scale: number): TextureChannel => ({ texture, channel, scale, bias: 0 });
    return {
      roughness: roughness * channelMean(texture, 1),
      roughnessTexture: channel(1, roughness),
      metallic: metallic * channelMean(texture, 2),
      metallicTexture: channel(2, metallic),
    };
  }

  private glossy(
    from: PBRSpecularGlossiness,
    diffuseTexture: Texture | undefined,
  ): Partial<Material> & MetallicRoughness {
    const [r, g, b] = from.getDiffuseFactor();
    const [image, info] = [from.getSpecularGlossinessTexture(), from.getSpecularGlossinessTextureInfo()];
    const specularTexture = this.texture(image, info, false);
    return fromSpecularGlossiness({
      diffuse: [r, g, b],
      specular: from.getSpecularFactor(),
      glossiness: from.getGlossinessFactor(),
      ...(diffuseTexture && { diffuseTexture }),
      ...(specularTexture && { specularTexture }),
    });
  }

  private normals(material: GltfMaterial): { readonly normalTexture?: NormalTexture } {
    const normalTexture = this.reader.normal(
      material.getNormalTexture(),
      material.getNormalTextureInfo(),
      material.getNormalScale(),
    );
    return normalTexture ? { normalTexture } : {};
  }

  /** Ambient occlusion, 1 + strength · (red − 1). */
  private occlusion(material: GltfMaterial): { readonly occlusionTexture?: TextureChannel } {
    const texture = this.texture(material.getOcclusionTexture(), material.getOcclusionTextureInfo(), true, 'linear');
    const strength = Math.min(Math.max(material.getOcclusionStrength(), 0), 1);
    return texture ? { occlusionTexture: { texture, channel: 0, scale: strength, bias: 1 - strength } } : {};
  }

  /** Spectral properties from the material's extras. */
  private spectral(material: GltfMaterial, name: string): Partial<Material> {
    const extras = new Map(Object.entries(material.getExtras()));
    const refuse = (message: Message): void =>
      this.context.notes.add('warning', 'gltf.slowlight', msg`material ${name}`, message);
    const pictures = INVISIBLE_BANDS.flatMap((hint) => {
      const told = this.channelOf(extras.get(hint.name));
      if (told) extras.delete(hint.name);
      const mean = told && told.scale * channelMean(told.texture, told.channel) + told.bias;
      return told ? [{ [hint.of]: Math.min(1, Math.max(0, mean ?? 0)), [hint.texture]: told }] : [];
    });
    return Object.assign(
      parseSpectralHints((hint) => extras.get(hint), refuse),
      ...pictures,
    );
  }

  /** `{ "image": 2, "channel": 0, "scale": 1, "bias": 0 }`; only the image is required. */
  private channelOf(value: unknown): TextureChannel | undefined {
    if (typeof value !== 'object' || value === null) return undefined;
    const { image, channel = 0, scale = 1, bias = 0 }: Record<string, unknown> = { ...value };
    const picture = this.context.document.getRoot().listTextures()[Number(image)];
    const isWhole = channel === 0 || channel === 1 || channel === 2 || channel === 3;
    if (!picture || !isWhole || typeof scale !== 'number' || typeof bias !== 'number') return undefined;
    const decoded = this.decode(picture);
    if (!decoded) return undefined;
    const { width, height, data } = decoded;
    const name = inEnglish(this.imageName(picture));
    const shown = { colorSpace: 'linear', filter: 'linear', wrapS: 'repeat', wrapT: 'repeat' } as const;
    return { texture: { name, width, height, data, ...shown }, channel, scale, bias };
  }

  private texture(
    image: GltfTexture | null,
    info: TextureInfo | null,
    opaque: boolean,
    colorSpace: Texture['colorSpace'] = 'srgb',
  ): Texture | undefined {
    if (!image || !info) return undefined;
    const decoded = this.decode(image);
    if (!decoded) return undefined;
    return {
      name: inEnglish(this.imageName(image)),
      width: decoded.width,
      height: decoded.height,
      data: opaque ? withoutAlpha(decoded.data) : decoded.data,
      colorSpace,
      filter: info.getMagFilter() === NEAREST ? 'nearest' : 'linear',
      wrapS: WRAPS[info.getWrapS()] ?? 'repeat',
      wrapT: WRAPS[info.getWrapT()] ?? 'repeat',
    };
  }

  private decode(image: GltfTexture): DecodedImage | undefined {
    if (this.images.has(image)) return this.images.get(image);
    const { pictures, document } = this.context;
    const place = document.getRoot().listTextures().indexOf(image);
    if (pictures.has(place)) return pictures.get(place);
    const bytes = image.getImage();
    const name = this.imageName(image);
    let decoded: DecodedImage | undefined;
    try {
      // Missing files have been reported already and have no bytes.
      decoded = bytes && bytes.length > 0 ? decodeImage(bytes, name) : undefined;
    } catch (thrown) {
      if (!(thrown instanceof InputError)) throw thrown;
      this.context.notes.add(
        'warning',
        'file.unreadable-texture',
        name,
        msg`${thrown.diagnostic.message}; shown without it`,
      );
    }
    this.images.set(image, decoded);
    return decoded;
  }

  private imageName(image: GltfTexture): LocalizedText {
    const place = this.context.document.getRoot().listTextures().indexOf(image);
    return image.getURI() || image.getName() || msg`image ${place}`;
  }
}

/** It reflects nothing, not even at grazing angles. */
const UNLIT = { ior: 1, unlit: true } as const;

type MetallicRoughness = Pick<Material, 'roughness' | 'roughnessTexture' | 'metallic' | 'metallicTexture'>;

const NEAREST = 9728;
const WRAPS: Readonly<Record<number, TextureWrap>> = { 10497: 'repeat', 33071: 'clamp', 33648: 'mirror' };

const DEFAULT_MATERIAL: Material = {
  name: 'default',
  baseColor: [1, 1, 1],
  emissive: ZERO,
  roughness: 1,
  metallic: 1,
  opacity: 1,
  opacityThreshold: 0,
};

const UNLIT_DEFAULT: Material = { ...DEFAULT_MATERIAL, ...UNLIT, baseColor: ZERO, emissive: [1, 1, 1], metallic: 0 };

function nameOf(context: GltfContext, material: GltfMaterial): string {
  return material.getName() || `material ${context.document.getRoot().listMaterials().indexOf(material)}`;
}

/** Opaque materials ignore the texture's alpha. */
function withoutAlpha(rgba: Uint8Array): Uint8Array {
  let opaque = true;
  for (let i = 3; i < rgba.length && opaque; i += 4) opaque = rgba[i] === 255;
  if (opaque) return rgba;
  const out = rgba.slice();
  for (let i = 3; i < out.length; i += 4) out[i] = 255;
  return out;
}

/** UV source of a material. A mesh has one UV set: that of the material's first texture. */
export function uvSourceOf(context: GltfContext, material: GltfMaterial | null): GltfUvSource {
  const [first, ...more] = material ? uvSources(material) : [];
  const other = material && more.find(({ source }) => JSON.stringify(source) !== JSON.stringify(first.source));
  if (other) {
    const message = msg`its ${other.what} has its own uv set or transform; that of the ${first.what} is used for both`;
    context.notes.add('warning', 'gltf.second-uvs', msg`material ${nameOf(context, material)}`, message);
  }
  return first?.source ?? { set: 0, offset: [0, 0], rotation: 0, scale: [1, 1] };
}

function uvSources(m: GltfMaterial): { readonly what: Message; readonly source: GltfUvSource }[] {
  const source = (what: Message, texture: GltfTexture | null, info: TextureInfo | null) =>
    texture ? [{ what, source: uvSource(info) }] : [];
  const glossy = m.getExtension<PBRSpecularGlossiness>('KHR_materials_pbrSpecularGlossiness');
  const own = glossy
    ? [
        ...source(msg`diffuse texture`, glossy.getDiffuseTexture(), glossy.getDiffuseTextureInfo()),
        ...source(
          msg`specular-glossiness texture`,
          glossy.getSpecularGlossinessTexture(),
          glossy.getSpecularGlossinessTextureInfo(),
        ),
      ]
    : source(msg`base colour texture`, m.getBaseColorTexture(), m.getBaseColorTextureInfo());
  return [
    ...own,
    ...source(msg`emissive texture`, m.getEmissiveTexture(), m.getEmissiveTextureInfo()),
    ...source(msg`normal texture`, m.getNormalTexture(), m.getNormalTextureInfo()),
    ...(glossy
      ? []
      : source(msg`metallic-roughness texture`, m.getMetallicRoughnessTexture(), m.getMetallicRoughnessTextureInfo())),
    ...source(msg`occlusion texture`, m.getOcclusionTexture(), m.getOcclusionTextureInfo()),
    ...layerTextures(m).flatMap(([what, texture, info]) => source(what, texture, info)),
  ];
}

function uvSource(info: TextureInfo | null): GltfUvSource {
  const transform = info?.getExtension<Transform>('KHR_texture_transform');
  return {
    set: transform?.getTexCoord() ?? info?.getTexCoord() ?? 0,
    offset: transform?.getOffset() ?? [0, 0],
    rotation: transform?.getRotation() ?? 0,
    scale: transform?.getScale() ?? [1, 1],
  };
}
