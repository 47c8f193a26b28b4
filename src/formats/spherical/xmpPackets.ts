import { unzlibSync } from 'fflate';
import { msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { type PngChunk, pngChunk, pngChunks, withPngChunks } from '../image/pngChunks.ts';

/** Keyword of the iTXt chunk, and name of the APP1 segment, that hold XMP (ISO 16684-3, 1.1.5 and 1.1.3). */
const PNG_KEYWORD = 'XML:com.adobe.xmp\0';
const JPEG_NAME = 'http://ns.adobe.com/xap/1.0/\0';
/** Largest size of a compressed packet when unpacked [bytes]. */
const MAX_UNPACKED = 2 ** 20;

/** A PNG with an XMP packet, in place of one that it had. */
export function withPngXmp(png: Uint8Array, packet: string): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(`${PNG_KEYWORD}\0\0\0\0${packet}`);
  const others = [...pngChunks(png)].filter(isXmp).reverse();
  const bare = others.reduce<Uint8Array>((bytes, { from, to }) => without(bytes, from, to), png);
  return withPngChunks(bare, [pngChunk('iTXt', text)]);
}

function without(bytes: Uint8Array, from: number, to: number): Uint8Array {
  const out = new Uint8Array(bytes.length - (to - from));
  out.set(bytes.subarray(0, from));
  out.set(bytes.subarray(to), from);
  return out;
}

const isXmp = ({ type, content }: PngChunk): boolean => type === 'iTXt' && startsWith(content, 0, PNG_KEYWORD);

const startsWith = (bytes: Uint8Array, at: number, text: string): boolean =>
  [...text].every((character, i) => bytes[at + i] === character.charCodeAt(0));

/** The XMP packet of a PNG; undefined where there is none. */
export function pngXmp(png: Uint8Array): Uint8Array | undefined {
  for (const chunk of pngChunks(png)) if (isXmp(chunk)) return textOf(chunk);
  return undefined;
}

/** Keyword, flag and method of compression, language, translated keyword, text (PNG, 11.3.3.4). */
function textOf({ content, from }: PngChunk): Uint8Array {
  const isCompressed = content[PNG_KEYWORD.length] !== 0;
  const language = content.indexOf(0, PNG_KEYWORD.length + 2);
  const translated = language < 0 ? -1 : content.indexOf(0, language + 1);
  if (translated < 0) throw new MessageError(msg`the XMP chunk at byte ${from} is damaged`);
  const text = content.subarray(translated + 1);
  return isCompressed ? unpack(text) : text;
}

/** Memory is bounded, whatever the packet unpacks to. */
function unpack(packed: Uint8Array): Uint8Array {
  try {
    return unzlibSync(packed, { out: new Uint8Array(MAX_UNPACKED) });
  } catch (thrown) {
    throw new MessageError(msg`the compressed XMP is damaged (${messageOf(thrown)})`, { cause: thrown });
  }
}

/** The XMP packet of a JPEG, in a segment before its pixels (ITU T.81, B.1.1.4); undefined where there is none. */
export function jpegXmp(jpeg: Uint8Array): Uint8Array | undefined {
  for (let at = 2; ; ) {
    const marker = jpeg[at + 1];
    if (jpeg[at] === 0xff && (marker === START_OF_SCAN || marker === END_OF_IMAGE)) return undefined;
    if (jpeg[at] === 0xff && marker === 0xff) {
      at++;
      continue;
    }
    const end = at + 2 + ((jpeg[at + 2] << 8) | jpeg[at + 3]);
    if (jpeg[at] !== 0xff || end < at + 4 || end > jpeg.length)
      throw new MessageError(msg`the JPEG is damaged or cut off at byte ${at}; copy it again`);
    if (marker === APP1 && startsWith(jpeg, at + 4, JPEG_NAME)) return jpeg.subarray(at + 4 + JPEG_NAME.length, end);
    at = end;
  }
}

const [START_OF_SCAN, END_OF_IMAGE, APP1] = [0xda, 0xd9, 0xe1];
