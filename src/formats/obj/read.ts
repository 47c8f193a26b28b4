import type { Material, Scene } from '../../scene/types.ts';
import { inputError } from '../fail.ts';
import { Notes } from '../notes.ts';
import { plainScene } from '../plainScene.ts';
import type { FileSource } from '../source.ts';
import { lineError, type ObjContext, type Statement } from './context.ts';
import { ObjGeometry } from './geometry.ts';
import { MaterialLibrary } from './materials.ts';
import { meshOf, type Worn } from './meshes.ts';
import { statements } from './statements.ts';

/** Most kinds of statements that are passed over: the format itself has fewer. */
const MAX_UNREAD = 100;

/**
 * Reads Wavefront OBJ with its materials (.mtl) and pictures as resting meshes, one for each object and group. Throws an
 * InputError that names file, line and value where it cannot; what it leaves out is in the scene's diagnostics.
 */
export async function readObj(source: FileSource, entry: string): Promise<Scene> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, 'no such file');
  const context: ObjContext = { source, entry, notes: new Notes(entry) };
  const geometry = new ObjGeometry(entry);
  const library = new MaterialLibrary(context);
  const unread = new Map<string, Statement>();
  for (const statement of statements(bytes, entry)) {
    if (statement.keyword === 'mtllib') await library.load(statement);
    else if (!apply(geometry, statement) && !unread.has(statement.keyword)) unread.set(statement.keyword, statement);
    if (unread.size <= MAX_UNREAD) continue;
    const message = `it is no Wavefront OBJ: there are more than ${MAX_UNREAD} kinds of statements that are not known`;
    throw lineError(entry, statement.line, 'obj.not-obj', message);
  }
  geometry.checkIndices();
  noteUnread(context, unread);
  const { materials, worn } = await wear(geometry, library);
  const meshes = geometry.parts.map((part) => ({ name: part.name, mesh: meshOf(geometry, part, worn) }));
  return plainScene(entry, meshes, materials, context.notes);
}

/** Whether the statement is one that is read. */
function apply(geometry: ObjGeometry, statement: Statement): boolean {
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

const UNREAD: ReadonlyMap<string, string> = new Map([
  ['p', 'points are'],
  ['l', 'lines are'],
  ['curv', 'curves are'],
  ['curv2', 'curves are'],
  ['surf', 'curved surfaces are'],
]);
/** Words that only accompany others, or change nothing of a shape. */
const SILENT =
  /^(cstype|deg|bmat|step|parm|trim|hole|scrv|sp|end|con|mg|vp|bevel|c_interp|d_interp|lod|shadow_obj|trace_obj|ctech|stech|usemap|maplib)$/;

function noteUnread({ notes }: ObjContext, unread: ReadonlyMap<string, Statement>): void {
  for (const [keyword, { line }] of unread) {
    const what = UNREAD.get(keyword);
    if (what) notes.add('warning', 'obj.ignored', `line ${line}`, `${what} not shown (${keyword}, first on this line)`);
    else if (!SILENT.test(keyword))
      notes.add(
        'info',
        'obj.unknown',
        `line ${line}`,
        `${keyword.slice(0, 40)} is not known; lines that begin with it are left out`,
      );
  }
}

async function wear(geometry: ObjGeometry, library: MaterialLibrary): Promise<{ materials: Material[]; worn: Worn[] }> {
  const materials: Material[] = [];
  const worn: Worn[] = [];
  for (const name of geometry.materials) {
    const { material, uvs } = await library.read(name);
    worn.push(uvs ? { place: worn.length, uvs } : { place: worn.length });
    materials.push(material);
  }
  return { materials, worn };
}
