import { contentSize, type FileContent } from '../../files/rangedFile.ts';
import type { Layer } from '../layer/layer.ts';
import { LayerBuilder } from './layerBuilder.ts';
import { SpecReader } from './specReader.ts';
import { readSections } from './structure/bootstrap.ts';
import { CrateSource } from './structure/crateSource.ts';
import { readStructure } from './structure/structure.ts';

/**
 * What a file is read to [bytes]: a few of its bytes can stand for any number. Small prims deep in others take up to 90
 * times their share of the file; arrays of one number, thousands of times.
 */
const budgetOf = (size: number): number => Math.max(Math.min(2 ** 26 + 128 * size, 2 ** 31), 4 * size);

/**
 * Reads a binary USD layer (a crate, versions 0.4 to 0.15) into the same model as text. Throws an InputError that names
 * the file, the section or the path, and the byte. Of what is not in memory, large arrays stay in the file (storedArray.ts).
 */
export function readCrate(content: FileContent, file: string): Layer {
  const source = new CrateSource(content, file, budgetOf(contentSize(content)));
  const sections = readSections(source);
  return new LayerBuilder(new SpecReader(source, readStructure(source, sections))).layer();
}
