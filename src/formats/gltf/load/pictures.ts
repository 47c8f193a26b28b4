import type { GLTF } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { InputError } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import type { DecodedImage } from '../../image/decodeImage.ts';
import { type DecodePicture, decodeForeign, foreignKind } from '../../image/foreignPictures.ts';
import type { DecodedPictures, Resources } from '../context.ts';
import { textureSlots } from './textureSlots.ts';

/** Extensions that name a picture beside that of the texture; the smaller comes first. */
export const PICTURE_EXTENSIONS = ['EXT_texture_avif', 'EXT_texture_webp'] as const;

interface GltfPictures {
  readonly json: GLTF.IGLTF;
  readonly resources: Resources;
  /** Where GLBs have their bytes. */
  readonly glb: string;
  readonly notes: DiagnosticLog;
}

/**
 * Decodes the pictures of textures in use that the host decodes, by image, and makes each the texture's own. Where one
 * cannot be read, the texture keeps the picture that it has beside.
 */
export async function decodePictures(file: GltfPictures, decode: DecodePicture): Promise<DecodedPictures> {
  const { json, notes } = file;
  const pictures = new Map<number, DecodedImage | undefined>();
  const slots = (json.materials ?? []).flatMap((material) => textureSlots(material));
  for (const index of new Set(slots.map(({ info }) => info.index))) {
    const texture = json.textures?.[index];
    if (!texture) continue;
    for (const image of [...alternatives(texture), texture.source]) {
      if (image === undefined) continue;
      const bytes = imageBytes(file, image);
      const kind = bytes && foreignKind(bytes);
      if (!pictures.has(image) && kind) {
        const name = json.images?.[image]?.uri ?? json.images?.[image]?.name ?? msg`image ${image}`;
        try {
          pictures.set(image, await decodeForeign(bytes, kind, name, decode));
        } catch (thrown) {
          if (!(thrown instanceof InputError)) throw thrown;
          const message = msg`${thrown.diagnostic.message}; shown without it`;
          notes.add('warning', 'file.unreadable-texture', name, message);
          pictures.set(image, undefined);
        }
      }
      if (!pictures.get(image)) continue;
      texture.source = image;
      break;
    }
  }
  return pictures;
}

const alternatives = ({ extensions }: GLTF.ITexture): readonly (number | undefined)[] =>
  PICTURE_EXTENSIONS.map((name) => (extensions?.[name] as { source?: number } | undefined)?.source);

/** Undefined where the file does not have them, which its checks tell. */
function imageBytes({ json, resources, glb }: GltfPictures, image: number): Uint8Array | undefined {
  const { uri, bufferView = -1 } = json.images?.[image] ?? {};
  if (uri !== undefined) return resources[uri];
  const { buffer = -1, byteOffset = 0, byteLength = 0 } = json.bufferViews?.[bufferView] ?? {};
  const held = json.buffers?.[buffer];
  return held && resources[held.uri ?? glb]?.subarray(byteOffset, byteOffset + byteLength);
}
