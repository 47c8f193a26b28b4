import { type Message, msg } from '../../messages/message.ts';
import type { Material, Scene } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import type { FileSource } from '../files/fileSource.ts';
import { meshScene } from '../read/meshScene.ts';
import { lineError, type ObjContext, type ObjStatement } from './context.ts';
import { ObjGeometry } from './geometry.ts';
import { ObjMaterialLibrary } from './materials.ts';
import { type FaceMaterial, meshOf } from './meshes.ts';
import { statements } from './statements.ts';

/** Maximum number of unknown keywords; the format itself has fewer. */
const MAX_UNREAD = 100;

/**
 * Reads Wavefront OBJ with its materials (.mtl) and textures as static meshes, one per object and group. Throws an
 * InputError with file, line and value; omissions are in the scene's diagnostics.
 */
export async function readObj(source: FileSource, entry: string): Promise<Scene> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, msg`no such file`);
  const context: ObjContext = { source, entry, notes: new DiagnosticLog(entry) };
  const geometry = new ObjGeometry(entry);
  const library = new ObjMaterialLibrary(context);
  const unread = new Map<string, ObjStatement>();
  for (const statement of statements(bytes, entry)) {
    if (statement.keyword === 'mtllib') await library.load(statement);
    else if (!apply(geometry, statement) && !unread.has(statement.keyword)) unread.set(statement.keyword, statement);
    if (unread.size <= MAX_UNREAD) continue;
    const message = msg`it is no Wavefront OBJ: there are more than ${MAX_UNREAD} kinds of statements that are not known`;
    throw lineError(entry, statement.line, 'obj.not-obj', message);
  }
  geometry.checkIndices(context.notes);
  noteUnread(context, unread);
  const { materials, faceMaterials } = await readMaterials(geometry, library);
  const meshes = geometry.parts.map((part) => ({ name: part.name, mesh: meshOf(geometry, part, faceMaterials) }));
  return meshScene(entry, meshes, materials, context.notes);
}

/** Handles a statement; false if it is not supported. */
function apply(geometry: ObjGeometry, statement: ObjStatement): boolean {
  const { keyword, rest, words } = statement;
  if (keyword === 'v') geometry.addPoint(statement);
  else if (keyword === 'vt') geometry.addUv(statement);
  else if (keyword === 'vn') geometry.addNormal(statement);
  else if (keyword === 'f' || keyword === 'fo') geometry.addFace(statement);
  else if (keyword === 'o') geometry.setObject(rest);
  else if (keyword === 'g') geometry.setGroup(words.join('_'));
  else if (keyword === 'usemtl') geometry.setMaterial(rest);
  else if (keyword === 's') geometry.setSmoothing(statement);
  else return false;
  return true;
}

const UNREAD: ReadonlyMap<string, Message> = new Map([
  ['p', msg`points are`],
  ['l', msg`lines are`],
  ['curv', msg`curves are`],
  ['curv2', msg`curves are`],
  ['surf', msg`curved surfaces are`],
]);
/** Keywords that are ignored silently: they accompany unsupported statements or do not affect the geometry. */
const SILENT =
  /^(cstype|deg|bmat|step|parm|trim|hole|scrv|sp|end|con|mg|vp|bevel|c_interp|d_interp|lod|shadow_obj|trace_obj|ctech|stech|usemap|maplib)$/;

function noteUnread({ notes }: ObjContext, unread: ReadonlyMap<string, ObjStatement>): void {
  for (const [keyword, { line }] of unread) {
    const what = UNREAD.get(keyword);
    if (what)
      notes.add('warning', 'obj.ignored', msg`line ${line}`, msg`${what} not shown (${keyword}, first on this line)`);
    else if (!SILENT.test(keyword))
      notes.add(
        'info',
        'obj.unknown',
        msg`line ${line}`,
        msg`${keyword.slice(0, 40)} is not known; lines that begin with it are left out`,
      );
  }
}

async function readMaterials(
  geometry: ObjGeometry,
  library: ObjMaterialLibrary,
): Promise<{ materials: Material[]; faceMaterials: FaceMaterial[] }> {
  const materials: Material[] = [];
  const faceMaterials: FaceMaterial[] = [];
  for (const name of geometry.materials) {
    const { material, uvs } = await library.read(name);
    faceMaterials.push(uvs ? { place: faceMaterials.length, uvs } : { place: faceMaterials.length });
    materials.push(material);
  }
  return { materials, faceMaterials };
}
