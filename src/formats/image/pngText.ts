import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { pngChunk, pngChunks, withPngChunks } from './pngChunks.ts';

/**
 * A PNG that also tells `texts`, each as a tEXt chunk with its key as the keyword (W3C Portable Network Graphics, third edition, 11.3.3.2).
 * Keys have 1 … 79 characters; both are Latin-1, which is all that such a chunk can hold.
 */
export const withPngText = (png: Uint8Array, texts: Readonly<Record<string, string>>): Uint8Array<ArrayBuffer> =>
  withPngChunks(
    png,
    Object.entries(texts).map(([key, text]) => textChunk(key, text)),
  );

/** What its tEXt chunks say, by their keywords. */
export function pngTexts(png: Uint8Array): ReadonlyMap<string, string> {
  const texts = new Map<string, string>();
  for (const { type, content } of pngChunks(png)) {
    if (type !== 'tEXt') continue;
    const [key, ...text] = String.fromCharCode(...content.subarray(0, MAX_TEXT)).split('\0');
    texts.set(key!, text.join('\0'));
  }
  return texts;
}

/** Longest text that is read [bytes]. */
const MAX_TEXT = 4096;

function textChunk(key: string, text: string): Uint8Array {
  const content = latin1(`${key}\0${text}`);
  if (key.length < 1 || key.length > 79) throw new MessageError(msg`a PNG keyword has 1 … 79 characters, not “${key}”`);
  return pngChunk('tEXt', content);
}

function latin1(text: string): Uint8Array {
  return Uint8Array.from(text, (character) => {
    const code = character.codePointAt(0)!;
    if (code > 255) throw new MessageError(msg`“${character}” cannot stand in the text of a PNG`);
    return code;
  });
}
