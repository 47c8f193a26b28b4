import type { Document, Material as GltfMaterial, Texture as GltfTexture, TextureInfo } from '@gltf-transform/core';
import { KHRMaterialsEmissiveStrength, KHRMaterialsIOR, KHRMaterialsUnlit } from '@gltf-transform/extensions';
import { scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import type { Material, Scene, Texture, TextureChannel } from '../../../scene/types.ts';
import { INVISIBLE_BANDS, SPECTRAL_ATTRIBUTES } from '../../attributes/hints.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { redTexture } from '../../image/channelTexture.ts';
import { encodeTexture } from '../../image/encodeTexture.ts';
import { addLayers, type TextureOutputs } from './materialLayers.ts';
import { inChannel, metallicRoughnessTexture, occlusionTextureOf } from './metallicRoughness.ts';

const WRAPS = { repeat: 10497, clamp: 33071, mirror: 33648, black: 33071 } as const;
const FILTERS = { nearest: { mag: 9728, min: 9728 }, linear: { mag: 9729, min: 9987 } } as const;

/** Materials of glTF say too whether they have two sides: one of ours may become two. */
export class GltfMaterialWriter {
  private readonly document: Document;
  private readonly scene: Scene;
  private readonly losses: DiagnosticLog;
  private readonly made = new Map<string, GltfMaterial>();
  private readonly pictures = new Map<Uint8Array, GltfTexture>();

  private readonly writer: TextureOutputs = {
    color: (texture, set) => {
      if (texture) sampled(set(this.picture(texture)), texture);
    },
    number: (from, channel, set) => {
      if (!from) return undefined;
      const { texture, factor } = inChannel(from, channel);
      sampled(set(this.picture(texture, 'numbers')), texture);
      return factor;
    },
  };

  constructor(document: Document, scene: Scene, losses: DiagnosticLog) {
    this.document = document;
    this.scene = scene;
    this.losses = losses;
  }

  of(index: number, doubleSided: boolean): GltfMaterial {
    const key = `${index} ${doubleSided}`;
    const material = this.made.get(key) ?? this.make(this.scene.materials[index]).setDoubleSided(doubleSided);
    this.made.set(key, material);
    return material;
  }

  private make(m: Material): GltfMaterial {
    return m.unlit ? this.makeUnlit(m) : this.makeLit(m);
  }

  /** Its emission is the base colour of glTF. */
  private makeUnlit(m: Material): GltfMaterial {
    const { emissiveTexture, unlit: _, ior: __, ...rest } = m;
    const { baseColorTexture: ___, ...plain } = rest;
    const made = this.makeLit({
      ...plain,
      baseColor: m.emissive,
      emissive: ZERO,
      ...(emissiveTexture && { baseColorTexture: emissiveTexture }),
    });
    return made.setExtension('KHR_materials_unlit', this.document.createExtension(KHRMaterialsUnlit).createUnlit());
  }

  private makeLit(m: Material): GltfMaterial {
    const baseColor = this.clamped(m.baseColor, m.name);
    const made = this.document
      .createMaterial(m.name)
      .setBaseColorFactor([...baseColor, m.opacity])
      .setRoughnessFactor(m.roughness)
      .setMetallicFactor(m.metallic);
    const isClear = m.opacity < 1 || (m.baseColorTexture?.data.some((x, i) => i % 4 === 3 && x < 255) ?? false);
    if (m.opacityThreshold > 0) made.setAlphaMode('MASK').setAlphaCutoff(m.opacityThreshold);
    else if (isClear) made.setAlphaMode('BLEND');
    this.addEmission(made, m.emissive);
    if (m.ior !== undefined)
      made.setExtension('KHR_materials_ior', this.document.createExtension(KHRMaterialsIOR).createIOR().setIOR(m.ior));
    if (m.baseColorTexture) {
      made.setBaseColorTexture(this.picture(m.baseColorTexture));
      sampled(made.getBaseColorTextureInfo(), m.baseColorTexture);
    }
    if (m.emissiveTexture) {
      made.setEmissiveTexture(this.picture(m.emissiveTexture));
      sampled(made.getEmissiveTextureInfo(), m.emissiveTexture);
    }
    if (m.reflectance)
      this.losses.add(
        'warning',
        'convert.material',
        msg`material ${m.name}`,
        msg`its measured reflectance is lost, but for its colour and its means of ultraviolet and infrared: a table of it is written beside USD alone`,
      );
    this.addNormalTexture(made, m);
    this.addMetallicRoughness(made, m);
    this.addOcclusion(made, m);
    addLayers(this.document, made, m, this.writer);
    const numbers = SPECTRAL_ATTRIBUTES.map(({ of, name }) => [name, m[of]] as const);
    const pictures = INVISIBLE_BANDS.map(
      ({ texture, name }) => [name, m[texture] && this.imageOf(m[texture])] as const,
    );
    const hints = [...numbers, ...pictures].filter(([, value]) => value !== undefined);
    return hints.length > 0 ? made.setExtras(Object.fromEntries(hints)) : made;
  }

  private addNormalTexture(made: GltfMaterial, { name, normalTexture }: Material): void {
    if (!normalTexture) return;
    const [x, y] = normalTexture.strength;
    if (x !== y) {
      const message = msg`its normals are ${x} times as steep along u and ${y} times along v; the first is taken for both`;
      this.losses.add('warning', 'convert.texture', msg`material ${name}`, message);
    }
    made.setNormalTexture(this.picture(normalTexture.texture, 'numbers')).setNormalScale(x);
    sampled(made.getNormalTextureInfo(), normalTexture.texture);
  }

  private addMetallicRoughness(made: GltfMaterial, m: Material): void {
    const finish = metallicRoughnessTexture(m);
    if (!finish) return;
    made.setMetallicRoughnessTexture(this.picture(finish.texture, 'numbers'));
    made.setRoughnessFactor(finish.roughness).setMetallicFactor(finish.metallic);
    sampled(made.getMetallicRoughnessTextureInfo(), finish.texture);
  }

  private addOcclusion(made: GltfMaterial, { occlusionTexture: from }: Material): void {
    if (!from) return;
    const picture = occlusionTextureOf(from);
    made.setOcclusionTexture(this.picture(picture.texture, 'numbers')).setOcclusionStrength(picture.strength);
    sampled(made.getOcclusionTextureInfo(), picture.texture);
  }

  /** As our own extras name a channel; their pictures are linear. */
  private imageOf(from: TextureChannel): Record<string, number> {
    const { texture, channel, scale, bias } =
      from.texture.colorSpace === 'linear' ? from : { texture: redTexture(from), channel: 0, scale: 1, bias: 0 };
    const image = this.document.getRoot().listTextures().indexOf(this.picture(texture, 'numbers'));
    return { image, channel, scale, bias };
  }

  /** Factors of glTF are at most 1; what is brighter has a strength too. */
  private addEmission(made: GltfMaterial, emissive: Vec3): void {
    const most = Math.max(...emissive);
    made.setEmissiveFactor([...(most > 1 ? scale(emissive, 1 / most) : emissive)]);
    if (most <= 1) return;
    const strength = this.document.createExtension(KHRMaterialsEmissiveStrength).createEmissiveStrength();
    made.setExtension('KHR_materials_emissive_strength', strength.setEmissiveStrength(most));
  }

  private clamped(color: Vec3, name: string): Vec3 {
    const [r, g, b] = color.map((x) => Math.min(1, Math.max(0, x)));
    if (r !== color[0] || g !== color[1] || b !== color[2])
      this.losses.add(
        'warning',
        'convert.color',
        msg`material ${name}`,
        msg`its base colour ${color.join(', ')} is cut to 0 … 1`,
      );
    return [r, g, b];
  }

  private picture(texture: Texture, of: 'colors' | 'numbers' = 'colors'): GltfTexture {
    const known = this.pictures.get(texture.data);
    if (known) return known;
    if (texture.colorSpace === 'linear' && of === 'colors')
      this.losses.add('warning', 'convert.texture', texture.name, msg`its linear colours are taken as sRGB there`);
    const name =
      texture.name
        .replace(/^.*[/\\]/, '')
        .replace(/\.[^.]*$/, '')
        .replace(/[^\w-]/g, '_') || 'texture';
    const image = encodeTexture(texture.width, texture.height, texture.data);
    const made = this.document.createTexture(name).setMimeType('image/png').setImage(Uint8Array.from(image));
    this.pictures.set(texture.data, made);
    return made;
  }
}

function sampled(info: TextureInfo | null, { filter, wrapS, wrapT }: Texture): void {
  info?.setMagFilter(FILTERS[filter].mag).setMinFilter(FILTERS[filter].min);
  info?.setWrapS(WRAPS[wrapS]).setWrapT(WRAPS[wrapT]);
}
