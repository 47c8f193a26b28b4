import { bytesOf, type Content, headOf } from '../rangedFile.ts';
import { IDENT_BYTES, isCrate } from './crate/bootstrap.ts';
import { readCrate } from './crate/read.ts';
import type { Layer } from './layer.ts';
import { parseLayer } from './parser.ts';

/** Reads one USD layer, text or binary, whatever its file is called. Throws an InputError that names the place. */
export const readLayer = (content: Content, name: string): Layer =>
  isCrate(headOf(content, IDENT_BYTES)) ? readCrate(content, name) : parseLayer(bytesOf(content), name);
