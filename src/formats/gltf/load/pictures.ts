import type { GLTF } from '@gltf-transform/core';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { InputError } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import type { DecodedImage } from '../../image/decodeImage.ts';
import { type DecodePicture, decodeForeign, foreignKind } from '../../image/foreignPictures.ts';
import { imageKind } from '../../image/imageKind.ts';
import type { DecodedPictures, Resources } from '../context.ts';
import { textureSlots } from './textureSlots.ts';

/** Extensions that name a picture beside that of the texture; the smaller comes first. Those of the host need its decoder. */
export const HOST_EXTENSIONS = ['EXT_texture_avif', 'EXT_texture_webp'] as const;
export const KTX2_EXTENSION = 'KHR_texture_basisu';

interface GltfPictures {
  readonly json: GLTF.IGLTF;
  readonly resources: Resources;
  /** Where GLBs have their bytes. */
  readonly glb: string;
  readonly notes: DiagnosticLog;
}

/**
 * Decodes the pictures of textures in use that are KTX2, or that the host decodes if it can, by image, and makes each the texture's own. Where one
 * cannot be read, the texture keeps the picture that it has beside.
 */
export async function decodePictures(file: GltfPictures, decode: DecodePicture | undefined): Promise<DecodedPictures> {
  const { json, notes } = file;
  const pictures = new Map<number, DecodedImage | undefined>();
  const slots = (json.materials ?? []).flatMap((material) => textureSlots(material));
  for (const index of new Set(slots.map(({ info }) => info.index))) {
    const texture = json.textures?.[index];
    if (!texture) continue;
    for (const image of [...alternatives(texture, decode !== undefined), texture.source]) {
      if (image === undefined) continue;
      const bytes = imageBytes(file, image);
      const decoder = bytes && decoderOf(bytes, decode);
      if (!pictures.has(image) && decoder) {
        const name = json.images?.[image]?.uri ?? json.images?.[image]?.name ?? msg`image ${image}`;
        try {
          pictures.set(image, await decoder(name));
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

/** Decodes a picture that is neither PNG nor JPEG; undefined for these, and for what cannot be decoded. */
function decoderOf(
  bytes: Uint8Array,
  decode: DecodePicture | undefined,
): ((name: LocalizedText) => Promise<DecodedImage>) | undefined {
  if (imageKind(bytes) === 'KTX2')
    return async (name) => (await import('../../image/ktx2/readKtx2.ts')).decodeKtx2(bytes, name);
  const kind = foreignKind(bytes);
  return kind && decode && ((name) => decodeForeign(bytes, kind, name, decode));
}

const alternatives = ({ extensions }: GLTF.ITexture, isHosted: boolean): readonly (number | undefined)[] =>
  [...(isHosted ? HOST_EXTENSIONS : []), KTX2_EXTENSION].map(
    (name) => (extensions?.[name] as { source?: number } | undefined)?.source,
  );

/** Undefined where the file does not have them, which its checks tell. */
function imageBytes({ json, resources, glb }: GltfPictures, image: number): Uint8Array | undefined {
  const { uri, bufferView = -1 } = json.images?.[image] ?? {};
  if (uri !== undefined) return resources[uri];
  const { buffer = -1, byteOffset = 0, byteLength = 0 } = json.bufferViews?.[bufferView] ?? {};
  const held = json.buffers?.[buffer];
  return held && resources[held.uri ?? glb]?.subarray(byteOffset, byteOffset + byteLength);
}
