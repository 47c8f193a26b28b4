import type { Material as GltfMaterial, Texture as GltfTexture, TextureInfo } from '@gltf-transform/core';
import type {
  Anisotropy,
  Clearcoat,
  Dispersion,
  Iridescence,
  Sheen,
  Specular,
  Transmission,
  Volume,
} from '@gltf-transform/extensions';
import type { Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import type { Material, NormalTexture, Texture, TextureChannel } from '../../../scene/types.ts';
import { channelMean } from '../../image/imageChannels.ts';

type Image = GltfTexture | null;
type Info = TextureInfo | null;

/** How textures of a material are read. */
export interface TextureInputs {
  /** A picture of numbers. */
  data(image: Image, info: Info): Texture | undefined;
  color(image: Image, info: Info): Texture | undefined;
  number(image: Image, info: Info, channel: TextureChannel['channel'], scale: number): TextureChannel | undefined;
  normal(image: Image, info: Info, scale: number): NormalTexture | undefined;
}

/** What extensions add to a material (scene/materials/layers.ts). */
export const layersOf = (material: GltfMaterial, textures: TextureInputs): Partial<Material> => ({
  ...specularOf(material.getExtension<Specular>('KHR_materials_specular'), textures),
  ...clearcoatOf(material.getExtension<Clearcoat>('KHR_materials_clearcoat'), textures),
  ...anisotropyOf(material.getExtension<Anisotropy>('KHR_materials_anisotropy'), textures),
  ...sheenOf(material.getExtension<Sheen>('KHR_materials_sheen'), textures),
  ...transmissionOf(material, textures),
  ...iridescenceOf(material.getExtension<Iridescence>('KHR_materials_iridescence'), textures),
});

/** A factor, and its texture: the factor is then the mean. */
function textured(factor: number, texture: TextureChannel | undefined): readonly [number, TextureChannel | undefined] {
  return [texture ? factor * channelMean(texture.texture, texture.channel) : factor, texture];
}

function specularOf(from: Specular | null, { color, number }: TextureInputs): Partial<Material> {
  if (!from) return {};
  const given = clamped(from.getSpecularFactor());
  const [factor, factorTexture] = textured(
    given,
    number(from.getSpecularTexture(), from.getSpecularTextureInfo(), 3, given),
  );
  const colorTexture = color(from.getSpecularColorTexture(), from.getSpecularColorTextureInfo());
  const [r, g, b] = from.getSpecularColorFactor().map((x) => Math.max(x, 0));
  const tint: Vec3 = [r, g, b];
  return {
    specular: { factor, ...(factorTexture && { factorTexture }), color: tint, ...(colorTexture && { colorTexture }) },
  };
}

function clearcoatOf(from: Clearcoat | null, { number, normal }: TextureInputs): Partial<Material> {
  if (!from || from.getClearcoatFactor() === 0) return {};
  const [given, rough] = [clamped(from.getClearcoatFactor()), clamped(from.getClearcoatRoughnessFactor())];
  const [factor, factorTexture] = textured(
    given,
    number(from.getClearcoatTexture(), from.getClearcoatTextureInfo(), 0, given),
  );
  const [roughness, roughnessTexture] = textured(
    rough,
    number(from.getClearcoatRoughnessTexture(), from.getClearcoatRoughnessTextureInfo(), 1, rough),
  );
  const normalTexture = normal(
    from.getClearcoatNormalTexture(),
    from.getClearcoatNormalTextureInfo(),
    from.getClearcoatNormalScale(),
  );
  return {
    clearcoat: {
      factor,
      ...(factorTexture && { factorTexture }),
      roughness,
      ...(roughnessTexture && { roughnessTexture }),
      ...(normalTexture && { normalTexture }),
    },
  };
}

function anisotropyOf(from: Anisotropy | null, { data }: TextureInputs): Partial<Material> {
  if (!from || from.getAnisotropyStrength() <= 0) return {};
  const directionTexture = data(from.getAnisotropyTexture(), from.getAnisotropyTextureInfo());
  return {
    anisotropy: {
      strength: clamped(from.getAnisotropyStrength()),
      rotation: from.getAnisotropyRotation(),
      ...(directionTexture && { directionTexture }),
    },
  };
}

function sheenOf(from: Sheen | null, { color, number }: TextureInputs): Partial<Material> {
  if (!from) return {};
  const [r, g, b] = from.getSheenColorFactor().map(clamped);
  if (r === 0 && g === 0 && b === 0) return {};
  const colorTexture = color(from.getSheenColorTexture(), from.getSheenColorTextureInfo());
  const given = clamped(from.getSheenRoughnessFactor());
  const [roughness, roughnessTexture] = textured(
    given,
    number(from.getSheenRoughnessTexture(), from.getSheenRoughnessTextureInfo(), 3, given),
  );
  return {
    sheen: {
      color: [r, g, b],
      ...(colorTexture && { colorTexture }),
      roughness,
      ...(roughnessTexture && { roughnessTexture }),
    },
  };
}

/** Thicknesses of glTF are in nanometres. */
function iridescenceOf(from: Iridescence | null, { number }: TextureInputs): Partial<Material> {
  if (!from || from.getIridescenceFactor() <= 0) return {};
  const given = clamped(from.getIridescenceFactor());
  const [factor, factorTexture] = textured(
    given,
    number(from.getIridescenceTexture(), from.getIridescenceTextureInfo(), 0, given),
  );
  const thicknessTexture = number(
    from.getIridescenceThicknessTexture(),
    from.getIridescenceThicknessTextureInfo(),
    1,
    1,
  );
  const metres = (nanometres: number): number => Math.max(nanometres, 0) * 1e-9;
  return {
    iridescence: {
      factor,
      ...(factorTexture && { factorTexture }),
      ior: Math.max(from.getIridescenceIOR(), 1),
      thickness: [metres(from.getIridescenceThicknessMinimum()), metres(from.getIridescenceThicknessMaximum())],
      ...(thicknessTexture && { thicknessTexture }),
    },
  };
}

function transmissionOf(material: GltfMaterial, { number }: TextureInputs): Partial<Material> {
  const from = material.getExtension<Transmission>('KHR_materials_transmission');
  if (!from || from.getTransmissionFactor() <= 0) return {};
  const given = clamped(from.getTransmissionFactor());
  const [factor, factorTexture] = textured(
    given,
    number(from.getTransmissionTexture(), from.getTransmissionTextureInfo(), 0, given),
  );
  const volume = material.getExtension<Volume>('KHR_materials_volume');
  const dispersion = material.getExtension<Dispersion>('KHR_materials_dispersion')?.getDispersion() ?? 0;
  return {
    transmission: { factor, ...(factorTexture && { factorTexture }) },
    ...(volume && volume.getThicknessFactor() > 0 && { volume: volumeOf(volume, number) }),
    ...(dispersion > 0 && { dispersion }),
  };
}

function volumeOf(from: Volume, number: TextureInputs['number']): NonNullable<Material['volume']> {
  const thicknessTexture = number(from.getThicknessTexture(), from.getThicknessTextureInfo(), 1, 1);
  const [r, g, b] = from.getAttenuationColor().map(clamped);
  const distance = from.getAttenuationDistance();
  return {
    thickness: from.getThicknessFactor(),
    ...(thicknessTexture && { thicknessTexture }),
    attenuationColor: [r, g, b],
    attenuationDistance: distance > 0 ? distance : Number.POSITIVE_INFINITY,
  };
}

const clamped = (x: number): number => Math.min(Math.max(x, 0), 1);

/** Textures of extensions, as messages call them. */
export function layerTextures(m: GltfMaterial): (readonly [Message, Image, Info])[] {
  const specular = m.getExtension<Specular>('KHR_materials_specular');
  const coat = m.getExtension<Clearcoat>('KHR_materials_clearcoat');
  const clear = m.getExtension<Transmission>('KHR_materials_transmission');
  const volume = m.getExtension<Volume>('KHR_materials_volume');
  const film = m.getExtension<Iridescence>('KHR_materials_iridescence');
  const sheen = m.getExtension<Sheen>('KHR_materials_sheen');
  const grooves = m.getExtension<Anisotropy>('KHR_materials_anisotropy');
  return [
    ...(clear
      ? ([[msg`transmission texture`, clear.getTransmissionTexture(), clear.getTransmissionTextureInfo()]] as const)
      : []),
    ...(film
      ? ([
          [msg`iridescence texture`, film.getIridescenceTexture(), film.getIridescenceTextureInfo()],
          [
            msg`iridescence thickness texture`,
            film.getIridescenceThicknessTexture(),
            film.getIridescenceThicknessTextureInfo(),
          ],
        ] as const)
      : []),
    ...(grooves
      ? ([[msg`anisotropy texture`, grooves.getAnisotropyTexture(), grooves.getAnisotropyTextureInfo()]] as const)
      : []),
    ...(sheen
      ? ([
          [msg`sheen colour texture`, sheen.getSheenColorTexture(), sheen.getSheenColorTextureInfo()],
          [msg`sheen roughness texture`, sheen.getSheenRoughnessTexture(), sheen.getSheenRoughnessTextureInfo()],
        ] as const)
      : []),
    ...(volume
      ? ([[msg`thickness texture`, volume.getThicknessTexture(), volume.getThicknessTextureInfo()]] as const)
      : []),
    ...(specular
      ? ([
          [msg`specular texture`, specular.getSpecularTexture(), specular.getSpecularTextureInfo()],
          [msg`specular colour texture`, specular.getSpecularColorTexture(), specular.getSpecularColorTextureInfo()],
        ] as const)
      : []),
    ...(coat
      ? ([
          [msg`clearcoat texture`, coat.getClearcoatTexture(), coat.getClearcoatTextureInfo()],
          [
            msg`clearcoat roughness texture`,
            coat.getClearcoatRoughnessTexture(),
            coat.getClearcoatRoughnessTextureInfo(),
          ],
          [msg`clearcoat normal texture`, coat.getClearcoatNormalTexture(), coat.getClearcoatNormalTextureInfo()],
        ] as const)
      : []),
  ];
}
