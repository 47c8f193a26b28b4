import { SaxesParser } from 'saxes';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** Largest size of a packet [bytes], and depth of its elements, that are read. */
const MAX_BYTES = 2 ** 20;
const MAX_DEPTH = 64;

/**
 * The values of an RDF/XML packet: its attributes and the text of its elements, by qualified name; the first of each.
 * Names are compared with the prefixes that their specifications prescribe, since early films do not declare them.
 * Entities other than those of XML itself are errors.
 */
export function xmlValues(bytes: Uint8Array): ReadonlyMap<string, string> {
  if (bytes.length > MAX_BYTES)
    throw new MessageError(msg`the XML has ${bytes.length} bytes; at most ${MAX_BYTES} are read`);
  const values = new Map<string, string>();
  const put = (name: string, value: string): unknown => values.has(name) || values.set(name, value.trim());
  const texts: string[] = [];
  const parser = new SaxesParser();
  parser.on('error', ({ message }) => {
    throw new MessageError(msg`the XML is not well-formed: ${message}`);
  });
  parser.on('opentag', ({ attributes }) => {
    if (texts.length >= MAX_DEPTH) throw new MessageError(msg`elements are nested more than ${MAX_DEPTH} deep`);
    for (const [name, value] of Object.entries(attributes)) put(name, value);
    texts.push('');
  });
  parser.on('text', (text) => {
    if (texts.length > 0) texts.push(texts.pop() + text);
  });
  parser.on('closetag', ({ name }) => put(name, texts.pop()!));
  // Some writers end the packet with zeros.
  parser.write(new TextDecoder().decode(bytes).replace(/\0+$/, '')).close();
  return values;
}
