import { deflateSync, Inflate } from 'fflate';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { DocumentError, type GraphDocument } from './document.ts';
import { parseDocument } from './parse.ts';
import { sortKeys } from './serialize.ts';
import { FRAGMENT_PREFIX, withoutHash } from './shareFragment.ts';

/** Maximum length of a link: what browsers, mail and chat programs pass on in full [characters]. */
const MAX_LINK_LENGTH = 2 ** 15;
/** Maximum unpacked size of a link [bytes]. */
const MAX_UNPACKED = 2 ** 20;
/** Inflation chunk size [bytes]: output never exceeds the limit by much, whatever the link says. */
const CHUNK_SIZE = 2 ** 10;

/**
 * A project as the fragment of a link, `project=…`: its text, deflated, as base64url (RFC 4648 § 5). Browsers do not
 * send fragments to servers. Throws a DocumentError if the project is too large for a link.
 * @example
 * encodeShareLink(emptyDocument()).startsWith('project='); // true
 */
export function encodeShareLink(document: GraphDocument): string {
  const packed = deflateSync(new TextEncoder().encode(JSON.stringify(sortKeys(document))), { level: 9 });
  const fragment = FRAGMENT_PREFIX + toBase64Url(packed);
  if (fragment.length <= MAX_LINK_LENGTH) return fragment;
  const sizes = msg`${fragment.length} characters of the ${MAX_LINK_LENGTH} that a link may have`;
  throw new DocumentError(msg`the link: the project is too large (${sizes}); save it to a file and send that`);
}

/**
 * Reads a link's fragment, with or without `#`; validated like a file. Throws a DocumentError.
 * @example
 * decodeShareLink(encodeShareLink({ ...emptyDocument(), title: 'Look' })).title; // 'Look'
 */
export function decodeShareLink(fragment: string): GraphDocument {
  const text = withoutHash(fragment);
  if (!text.startsWith(FRAGMENT_PREFIX)) throw new DocumentError(msg`the link: it carries no project`);
  if (text.length > MAX_LINK_LENGTH)
    throw new DocumentError(
      msg`the link: ${text.length} characters are more than the ${MAX_LINK_LENGTH} of one of ours`,
    );
  return parseDocument(decodeText(inflateBounded(fromBase64Url(text.slice(FRAGMENT_PREFIX.length)))));
}

const damagedLink = (what: LocalizedText): DocumentError =>
  new DocumentError(msg`the link: ${what}; it was cut off or changed on its way, ask for it again`);

function decodeText(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw damagedLink(msg`what it carries is no text`);
  }
}

function inflateBounded(packed: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = [];
  let size = 0;
  let ended = false;
  const inflate = new Inflate((part, final) => {
    size += part.length;
    if (size > MAX_UNPACKED) throw new DocumentError(msg`the link: it unpacks to more than ${MAX_UNPACKED} bytes`);
    parts.push(part);
    ended = final;
  });
  try {
    for (let at = 0; at < packed.length || at === 0; at += CHUNK_SIZE)
      inflate.push(packed.subarray(at, at + CHUNK_SIZE), at + CHUNK_SIZE >= packed.length);
  } catch (error) {
    throw error instanceof DocumentError ? error : damagedLink(msg`it cannot be unpacked`);
  }
  if (!ended) throw damagedLink(msg`it has no end`);
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function toBase64Url(bytes: Uint8Array): string {
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function fromBase64Url(text: string): Uint8Array {
  if (!/^[A-Za-z0-9_-]*$/.test(text)) throw damagedLink(msg`it has letters that no link of ours has`);
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  } catch {
    throw damagedLink(msg`it is not whole`);
  }
}
