import { deflateSync, Inflate } from 'fflate';
import { DocumentError, type GraphDocument } from './document.ts';
import { parseDocument } from './read.ts';
import { sorted } from './serialize.ts';

/** What a link may be long: what browsers, mail and chats pass on whole [characters]. */
const LONGEST_LINK = 2 ** 15;
/** What a link may unpack to [bytes]. */
const MOST_UNPACKED = 2 ** 20;
/** What is inflated at a time [bytes]: not much more than the bound is ever made, whatever a link says. */
const PORTION = 2 ** 10;
const KEY = 'project=';

/**
 * A project as the fragment of a link, `project=…`: its text, deflated, in the letters of base64url (RFC 4648 § 5). The part after `#`
 * never leaves the browser. Throws a DocumentError where the project is too large for a link.
 */
export function sharedFragment(document: GraphDocument): string {
  const packed = deflateSync(new TextEncoder().encode(JSON.stringify(sorted(document))), { level: 9 });
  const fragment = KEY + toBase64Url(packed);
  if (fragment.length <= LONGEST_LINK) return fragment;
  const sizes = `${fragment.length} characters of the ${LONGEST_LINK} that a link may have`;
  throw new DocumentError(`the link: the project is too large (${sizes}); save it to a file and send that`);
}

export const isShared = (fragment: string): boolean => bare(fragment).startsWith(KEY);

/** Reads what a link carries, with or without its `#`; checked as strictly as a file. Throws a DocumentError. */
export function readShared(fragment: string): GraphDocument {
  const text = bare(fragment);
  if (!text.startsWith(KEY)) throw new DocumentError('the link: it carries no project');
  if (text.length > LONGEST_LINK)
    throw new DocumentError(`the link: ${text.length} characters are more than the ${LONGEST_LINK} of one of ours`);
  return parseDocument(decoded(inflated(fromBase64Url(text.slice(KEY.length)))));
}

const bare = (fragment: string): string => fragment.replace(/^#/, '');

const damaged = (what: string): DocumentError =>
  new DocumentError(`the link: ${what}; it was cut off or changed on its way, ask for it again`);

function decoded(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw damaged('what it carries is no text');
  }
}

function inflated(packed: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = [];
  let size = 0;
  let ended = false;
  const inflate = new Inflate((part, final) => {
    size += part.length;
    if (size > MOST_UNPACKED) throw new DocumentError(`the link: it unpacks to more than ${MOST_UNPACKED} bytes`);
    parts.push(part);
    ended = final;
  });
  try {
    for (let at = 0; at < packed.length || at === 0; at += PORTION)
      inflate.push(packed.subarray(at, at + PORTION), at + PORTION >= packed.length);
  } catch (error) {
    throw error instanceof DocumentError ? error : damaged('it cannot be unpacked');
  }
  if (!ended) throw damaged('it has no end');
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
  if (!/^[A-Za-z0-9_-]*$/.test(text)) throw damaged('it has letters that no link of ours has');
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  } catch {
    throw damaged('it is not whole');
  }
}
