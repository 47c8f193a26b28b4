import { msg } from '../../messages/message.ts';
import { makeObject, makeScene } from '../../scene/defaults.ts';
import type { Material, Mesh, Scene } from '../../scene/types.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { stemOf } from '../files/fileSource.ts';
import { UniquePrimPaths } from './primPaths.ts';

/** A mesh and its name in the file; empty if none. */
export interface NamedMesh {
  readonly name: string;
  readonly mesh: Mesh;
}

/** Maximum number of corners of one polygon: triangulation takes O(n²). */
export const MAX_CORNERS = 4096;

/** Builds the scene of a format of static meshes without units or axes: lengths are taken as metres, Y as up, and that is reported. */
export function meshScene(
  entry: string,
  meshes: readonly NamedMesh[],
  materials: readonly Material[],
  notes: DiagnosticLog,
): Scene {
  const paths = new UniquePrimPaths();
  notes.add(
    'info',
    'file.units',
    '',
    msg`neither unit nor up axis is written in it; one unit is taken as 1 m, Y as up`,
  );
  if (meshes.length === 0)
    notes.add('warning', 'file.no-triangles', '', msg`no triangle is in it, so that there is nothing to see`);
  return makeScene({
    name: stemOf(entry),
    objects: meshes.map(({ name, mesh }) => makeObject({ path: paths.of('', name || stemOf(entry)), mesh })),
    materials,
    diagnostics: notes.list(),
  });
}
