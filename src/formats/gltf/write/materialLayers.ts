import type { Document, Material as GltfMaterial, Texture as GltfTexture, TextureInfo } from '@gltf-transform/core';
import {
  KHRMaterialsAnisotropy,
  KHRMaterialsClearcoat,
  KHRMaterialsDispersion,
  KHRMaterialsIridescence,
  KHRMaterialsSheen,
  KHRMaterialsSpecular,
  KHRMaterialsTransmission,
  KHRMaterialsVolume,
} from '@gltf-transform/extensions';
import type { Material, Texture, TextureChannel } from '../../../scene/types.ts';

/** Sets a texture, and returns how it is sampled. */
type SetTexture = (picture: GltfTexture) => TextureInfo | null;

/** How textures of a material are written. */
export interface TextureOutputs {
  color(texture: Texture | undefined, set: SetTexture): void;
  /** The factor to the texture; undefined if there is none. */
  number(from: TextureChannel | undefined, channel: number, set: SetTexture): number | undefined;
}

/** Writes what extensions add to a material (scene/materials/layers.ts). */
export function addLayers(document: Document, made: GltfMaterial, m: Material, textures: TextureOutputs): void {
  addSpecular(document, made, m, textures);
  addClearcoat(document, made, m, textures);
  addAnisotropy(document, made, m, textures);
  addSheen(document, made, m, textures);
  addTransmission(document, made, m, textures);
  addIridescence(document, made, m, textures);
}

function addIridescence(
  document: Document,
  made: GltfMaterial,
  { iridescence: from }: Material,
  textures: TextureOutputs,
): void {
  if (!from) return;
  const film = document.createExtension(KHRMaterialsIridescence).createIridescence().setIridescenceIOR(from.ior);
  const factor = textures.number(from.factorTexture, 0, (picture) =>
    film.setIridescenceTexture(picture).getIridescenceTextureInfo(),
  );
  textures.number(from.thicknessTexture, 1, (picture) =>
    film.setIridescenceThicknessTexture(picture).getIridescenceThicknessTextureInfo(),
  );
  const [thinnest, thickest] = from.thickness.map((metres) => metres * 1e9);
  film.setIridescenceFactor(factor ?? from.factor);
  film.setIridescenceThicknessMinimum(thinnest).setIridescenceThicknessMaximum(thickest);
  made.setExtension('KHR_materials_iridescence', film);
}

function addAnisotropy(
  document: Document,
  made: GltfMaterial,
  { anisotropy: from }: Material,
  textures: TextureOutputs,
): void {
  if (!from) return;
  const grooves = document.createExtension(KHRMaterialsAnisotropy).createAnisotropy();
  const { directionTexture } = from;
  if (directionTexture) {
    const whole = { texture: directionTexture, channel: 0, scale: 1, bias: 0 } as const;
    textures.number(whole, 0, (picture) => grooves.setAnisotropyTexture(picture).getAnisotropyTextureInfo());
  }
  grooves.setAnisotropyStrength(from.strength).setAnisotropyRotation(from.rotation);
  made.setExtension('KHR_materials_anisotropy', grooves);
}

function addSheen(document: Document, made: GltfMaterial, { sheen: from }: Material, textures: TextureOutputs): void {
  if (!from) return;
  const sheen = document.createExtension(KHRMaterialsSheen).createSheen();
  const roughness = textures.number(from.roughnessTexture, 3, (picture) =>
    sheen.setSheenRoughnessTexture(picture).getSheenRoughnessTextureInfo(),
  );
  textures.color(from.colorTexture, (picture) => sheen.setSheenColorTexture(picture).getSheenColorTextureInfo());
  sheen.setSheenColorFactor([...from.color]).setSheenRoughnessFactor(roughness ?? from.roughness);
  made.setExtension('KHR_materials_sheen', sheen);
}

function addTransmission(
  document: Document,
  made: GltfMaterial,
  { transmission, volume: inside, dispersion }: Material,
  textures: TextureOutputs,
): void {
  if (!transmission) return;
  const clear = document.createExtension(KHRMaterialsTransmission).createTransmission();
  const factor = textures.number(transmission.factorTexture, 0, (picture) =>
    clear.setTransmissionTexture(picture).getTransmissionTextureInfo(),
  );
  made.setExtension('KHR_materials_transmission', clear.setTransmissionFactor(factor ?? transmission.factor));
  if (dispersion) {
    const spread = document.createExtension(KHRMaterialsDispersion).createDispersion().setDispersion(dispersion);
    made.setExtension('KHR_materials_dispersion', spread);
  }
  if (!inside) return;
  const volume = document.createExtension(KHRMaterialsVolume).createVolume();
  const share = textures.number(inside.thicknessTexture, 1, (picture) =>
    volume.setThicknessTexture(picture).getThicknessTextureInfo(),
  );
  volume.setThicknessFactor(inside.thickness * (share ?? 1)).setAttenuationColor([...inside.attenuationColor]);
  if (Number.isFinite(inside.attenuationDistance)) volume.setAttenuationDistance(inside.attenuationDistance);
  made.setExtension('KHR_materials_volume', volume);
}

function addSpecular(
  document: Document,
  made: GltfMaterial,
  { specular: from }: Material,
  textures: TextureOutputs,
): void {
  if (!from) return;
  const specular = document.createExtension(KHRMaterialsSpecular).createSpecular();
  const factor = textures.number(from.factorTexture, 3, (picture) =>
    specular.setSpecularTexture(picture).getSpecularTextureInfo(),
  );
  textures.color(from.colorTexture, (picture) =>
    specular.setSpecularColorTexture(picture).getSpecularColorTextureInfo(),
  );
  specular.setSpecularFactor(factor ?? from.factor).setSpecularColorFactor([...from.color]);
  made.setExtension('KHR_materials_specular', specular);
}

function addClearcoat(
  document: Document,
  made: GltfMaterial,
  { clearcoat: from }: Material,
  textures: TextureOutputs,
): void {
  if (!from) return;
  const coat = document.createExtension(KHRMaterialsClearcoat).createClearcoat();
  const factor = textures.number(from.factorTexture, 0, (picture) =>
    coat.setClearcoatTexture(picture).getClearcoatTextureInfo(),
  );
  const roughness = textures.number(from.roughnessTexture, 1, (picture) =>
    coat.setClearcoatRoughnessTexture(picture).getClearcoatRoughnessTextureInfo(),
  );
  coat.setClearcoatFactor(factor ?? from.factor).setClearcoatRoughnessFactor(roughness ?? from.roughness);
  const { normalTexture } = from;
  if (normalTexture) {
    const whole = { texture: normalTexture.texture, channel: 0, scale: 1, bias: 0 } as const;
    textures.number(whole, 0, (picture) => coat.setClearcoatNormalTexture(picture).getClearcoatNormalTextureInfo());
    coat.setClearcoatNormalScale(normalTexture.strength[0]);
  }
  made.setExtension('KHR_materials_clearcoat', coat);
}
