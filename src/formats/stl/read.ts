import { msg } from '../../messages/message.ts';
import type { Scene } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import { meshScene } from '../read/meshScene.ts';
import { isBinaryStl, readBinaryStl } from './binary.ts';
import { type Facets, facetMesh } from './facets.ts';
import { readStlText } from './text.ts';

/**
 * Reads STL, text or binary, as resting meshes: one for each solid. Throws an InputError that names file, line or byte, and
 * value where it cannot.
 */
export async function readStl(source: FileSource, entry: string): Promise<Scene> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, msg`no such file`);
  const notes = new DiagnosticLog(entry);
  const solids = isBinaryStl(bytes) ? [readBinaryStl(bytes, entry, notes)] : readStlText(bytes, entry);
  noteTurned(solids, notes);
  const shown = solids.filter(({ points }) => points.length > 0);
  const meshes = shown.map((solid) => ({ name: solid.name, mesh: facetMesh(solid) }));
  return meshScene(entry, meshes, [], notes);
}

/** Reports facets whose normal and winding disagree; the winding is used. */
function noteTurned(solids: readonly Facets[], notes: DiagnosticLog): void {
  const turned = solids.reduce((sum, solid) => sum + solid.turned, 0);
  if (turned === 0) return;
  const message = msg`the normals of ${turned} facets say the opposite of the order of their corners, which is what is taken`;
  notes.add('info', 'stl.normals', '', message);
}
