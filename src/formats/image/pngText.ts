import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { crc32 } from '../files/crc32.ts';

/** Behind the signature and the header, which comes first. */
const AFTER_HEADER = 8 + 25;

/**
 * A PNG that also tells `texts`, each as a tEXt chunk with its key as the keyword (W3C Portable Network Graphics, third edition, 11.3.3.2).
 * Keys have 1 … 79 characters; both are Latin-1, which is all that such a chunk can hold.
 */
export function withPngText(png: Uint8Array, texts: Readonly<Record<string, string>>): Uint8Array<ArrayBuffer> {
  const chunks = Object.entries(texts).map(([key, text]) => textChunk(key, text));
  const out = new Uint8Array(png.length + chunks.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of [png.subarray(0, AFTER_HEADER), ...chunks, png.subarray(AFTER_HEADER)]) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

function textChunk(key: string, text: string): Uint8Array {
  const content = latin1(`tEXt${key}\0${text}`);
  if (key.length < 1 || key.length > 79) throw new MessageError(msg`a PNG keyword has 1 … 79 characters, not “${key}”`);
  const chunk = new Uint8Array(4 + content.length + 4);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, content.length - 4);
  chunk.set(content, 4);
  view.setUint32(4 + content.length, crc32(content));
  return chunk;
}

function latin1(text: string): Uint8Array {
  return Uint8Array.from(text, (character) => {
    const code = character.codePointAt(0)!;
    if (code > 255) throw new MessageError(msg`“${character}” cannot stand in the text of a PNG`);
    return code;
  });
}
