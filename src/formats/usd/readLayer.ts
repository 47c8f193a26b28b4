import { isCrate } from './crate/bootstrap.ts';
import { readCrate } from './crate/read.ts';
import type { Layer } from './layer.ts';
import { parseLayer } from './parser.ts';

/** Reads one USD layer, text or binary, whatever its file is called. Throws an InputError that names the place. */
export const readLayer = (bytes: Uint8Array, name: string): Layer =>
  isCrate(bytes) ? readCrate(bytes, name) : parseLayer(bytes, name);
