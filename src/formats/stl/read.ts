import type { Scene } from '../../scene/types.ts';
import { inputError } from '../fail.ts';
import { Notes } from '../notes.ts';
import { plainScene } from '../plainScene.ts';
import type { FileSource } from '../source.ts';
import { isBinary, readBinary } from './binary.ts';
import { type Facets, facetMesh } from './facets.ts';
import { readText } from './text.ts';

/**
 * Reads STL, text or binary, as resting meshes: one for each solid. Throws an InputError that names file, line or byte, and
 * value where it cannot.
 */
export async function readStl(source: FileSource, entry: string): Promise<Scene> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, 'no such file');
  const notes = new Notes(entry);
  const solids = isBinary(bytes) ? [readBinary(bytes, entry, notes)] : readText(bytes, entry);
  noteTurned(solids, notes);
  const shown = solids.filter(({ points }) => points.length > 0);
  const meshes = shown.map((solid) => ({ name: solid.name, mesh: facetMesh(solid) }));
  return plainScene(entry, meshes, [], notes);
}

/** The order of a facet's corners and its normal should say the same of what is outside; the order is what counts here. */
function noteTurned(solids: readonly Facets[], notes: Notes): void {
  const turned = solids.reduce((sum, solid) => sum + solid.turned, 0);
  if (turned === 0) return;
  const message = `the normals of ${turned} facets say the opposite of the order of their corners, which is what is taken`;
  notes.add('info', 'stl.normals', '', message);
}
