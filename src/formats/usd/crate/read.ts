import { type Content, sizeOf } from '../../rangedFile.ts';
import type { Layer } from '../layer.ts';
import { readSections } from './bootstrap.ts';
import { LayerBuilder } from './build.ts';
import { SpecReader } from './fields.ts';
import { CrateSource } from './source.ts';
import { readStructure } from './structure.ts';

/**
 * What a file is read to [bytes]: a few of its bytes can stand for any number. Small prims deep in others take up to 90
 * times their share of the file; arrays of one number, thousands of times.
 */
const budgetOf = (size: number): number => Math.max(Math.min(2 ** 26 + 128 * size, 2 ** 31), 4 * size);

/**
 * Reads a binary USD layer (a crate, versions 0.4 to 0.14) into the same model as text. Throws an InputError that names
 * the file, the section or the path, and the byte. Of what is not in memory, large arrays stay in the file (storedArray.ts).
 */
export function readCrate(content: Content, file: string): Layer {
  const source = new CrateSource(content, file, budgetOf(sizeOf(content)));
  const sections = readSections(source);
  return new LayerBuilder(new SpecReader(source, readStructure(source, sections))).layer();
}
