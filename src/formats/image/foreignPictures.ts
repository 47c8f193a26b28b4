import { type LocalizedText, msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { InputError } from '../../scene/types.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { checkSize, type DecodedImage } from './decodeImage.ts';
import { imageKind } from './imageKind.ts';

/** Kinds of pictures that the host decodes. */
export type ForeignKind = 'WebP' | 'AVIF';

/**
 * Decodes a picture to straight RGBA, without conversion of its colours: in a page by its browser, elsewhere by a codec. Its
 * size has been checked.
 */
export type DecodePicture = (bytes: Uint8Array<ArrayBuffer>, kind: ForeignKind) => Promise<DecodedImage>;

export const foreignKind = (bytes: Uint8Array): ForeignKind | undefined =>
  (['WebP', 'AVIF'] as const).find((kind) => kind === imageKind(bytes));

/** Throws an InputError that names `name`. */
export async function decodeForeign(
  bytes: Uint8Array,
  kind: ForeignKind,
  name: LocalizedText,
  decode: DecodePicture,
): Promise<DecodedImage> {
  const [width, height] = (kind === 'WebP' ? webpSize(bytes) : avifSize(bytes)) ?? [];
  if (width === undefined || height === undefined)
    throw inputError('image.damaged', name, msg`the ${kind} is damaged or cut off (${msg`no size`}); export it again`);
  checkSize(width, height, name);
  try {
    // Decoders take whole buffers.
    const image = await decode(bytes.slice(), kind);
    checkSize(image.width, image.height, name);
    return image;
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    const message = msg`the ${kind} is damaged or cut off (${messageOf(thrown)}); export it again`;
    throw inputError('image.damaged', name, message, thrown);
  }
}

type Size = readonly [number, number];

/** Of the first chunk (WebP Container Specification): VP8X, VP8L or VP8. */
function webpSize(bytes: Uint8Array): Size | undefined {
  if (bytes.length < 30) return undefined;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const u24 = (at: number): number => view.getUint16(at, true) | (view.getUint8(at + 2) << 16);
  switch (String.fromCharCode(...bytes.subarray(12, 16))) {
    case 'VP8X':
      return [1 + u24(24), 1 + u24(27)];
    case 'VP8L': {
      const bits = view.getUint32(21, true);
      return [1 + (bits & 0x3fff), 1 + ((bits >>> 14) & 0x3fff)];
    }
    case 'VP8 ':
      return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
    default:
      return undefined;
  }
}

/** Where the boxes that describe an AVIF's pictures end, at the latest [byte]. */
const AVIF_HEAD = 2 ** 16;

/** The largest of its image spatial extents (ISO/IEC 23008-12, `ispe`): the picture, its alpha, its tiles. */
function avifSize(bytes: Uint8Array): Size | undefined {
  const head = bytes.subarray(0, AVIF_HEAD);
  const view = new DataView(head.buffer, head.byteOffset, head.byteLength);
  const sizes: Size[] = [];
  for (let at = 0; at + 16 <= head.length; at++)
    if (view.getUint32(at) === 0x69737065) sizes.push([view.getUint32(at + 8), view.getUint32(at + 12)]);
  if (sizes.length === 0) return undefined;
  return [Math.max(...sizes.map(([width]) => width)), Math.max(...sizes.map(([, height]) => height))];
}
