import type { Layer } from '../layer.ts';
import { readSections } from './bootstrap.ts';
import { LayerBuilder } from './build.ts';
import { SpecReader } from './fields.ts';
import { CrateSource } from './source.ts';
import { readStructure } from './structure.ts';

/** What any file is read to [bytes], and so many times its own size above. A few bytes can stand for any number. */
const [LEAST_BUDGET, BUDGET_PER_BYTE] = [2 ** 26, 64];

/**
 * Reads a binary USD layer (a crate, versions 0.4 to 0.14) into the same model as text. Throws an InputError that names
 * the file, the section or the path, and the byte.
 */
export function readCrate(bytes: Uint8Array, file: string): Layer {
  const source = new CrateSource(bytes, file, LEAST_BUDGET + BUDGET_PER_BYTE * bytes.length);
  const sections = readSections(source);
  return new LayerBuilder(new SpecReader(source, readStructure(source, sections))).layer();
}
