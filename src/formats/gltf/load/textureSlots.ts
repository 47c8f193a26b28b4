import type { GLTF } from '@gltf-transform/core';

/** Where a material names a texture: `holder[name]` is `info`. */
export interface TextureSlot {
  readonly holder: Record<string, unknown>;
  readonly name: string;
  readonly info: GLTF.ITextureInfo;
}

/** All textures that a material names, those of its extensions too. */
export function textureSlots(material: GLTF.IMaterial): TextureSlot[] {
  const holders: readonly unknown[] = [
    material,
    material.pbrMetallicRoughness,
    ...Object.values(material.extensions ?? {}),
  ];
  return holders.flatMap((holder) => (isRecord(holder) ? slotsOf(holder) : []));
}

const slotsOf = (holder: Record<string, unknown>): TextureSlot[] =>
  Object.entries(holder).flatMap(([name, info]) =>
    name.endsWith('Texture') && isRecord(info) ? [{ holder, name, info: info as unknown as GLTF.ITextureInfo }] : [],
  );

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
