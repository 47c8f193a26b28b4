import { contentBytes, contentHead, type FileContent } from '../files/rangedFile.ts';
import { readCrate } from './crate/readCrate.ts';
import { IDENT_BYTES, isCrate } from './crate/structure/bootstrap.ts';
import type { Layer } from './layer/layer.ts';
import { parseLayer } from './text/parser.ts';

/** Reads one USD layer, text or binary, whatever its file is called. Throws an InputError that names the place. */
export const readLayer = (content: FileContent, name: string): Layer =>
  isCrate(contentHead(content, IDENT_BYTES)) ? readCrate(content, name) : parseLayer(contentBytes(content), name);
