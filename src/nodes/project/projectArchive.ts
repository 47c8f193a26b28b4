import { inputError } from '../../formats/diagnostics/inputError.ts';
import { memorySource, normalizePath } from '../../formats/files/fileSource.ts';
import { packZip } from '../../formats/zip/pack.ts';
import { memoryFile, zipSource } from '../../formats/zip/zipSource.ts';
import type { FileReference, GraphDocument } from '../../graph/document/document.ts';
import { referencedFiles } from '../../graph/document/fileReferences.ts';
import { parseDocument } from '../../graph/document/parse.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import { msg } from '../../messages/message.ts';
import { nodeLibrary } from '../library.ts';

/** File name of the project in its archive. */
export const PROJECT_FILE_NAME = 'project.slowlight.json';

/**
 * A project with its files as one zip. `files`: by the names under which the document refers to them, with the files
 * that these reference (textures, layers) beside them.
 * @example
 * const zip = await packProjectArchive(newProject('ball.usda'), new Map([['ball.usda', new Uint8Array([35])]]));
 * new TextDecoder().decode(zip.subarray(0, 2)); // 'PK'
 */
export async function packProjectArchive(
  document: GraphDocument,
  files: ReadonlyMap<string, Uint8Array>,
): Promise<Uint8Array> {
  const missing = referencedFiles(document, nodeLibrary).find((file) => !files.has(file));
  if (missing !== undefined)
    throw inputError('file.missing', missing, msg`the project reads it; open it again before the project is packed`);
  const references = await Promise.all(
    [...files].map(async ([path, bytes]) => [path, await fileReference(bytes)] as const),
  );
  const text = serializeDocument({ ...document, files: Object.fromEntries(references) });
  return packZip(new Map([[PROJECT_FILE_NAME, new TextEncoder().encode(text)], ...files]));
}

async function fileReference(bytes: Uint8Array): Promise<FileReference> {
  // Missing on pages served without encryption.
  if (!crypto.subtle) return { size: bytes.length };
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes.slice()));
  return { size: bytes.length, hash: [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('') };
}

/** An opened zip of a project. */
export interface ProjectArchive {
  /** The project. */
  readonly document: GraphDocument;
  /** The project's files, by the names under which the document refers to them. */
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/**
 * Reads what `packProjectArchive` wrote. Throws an InputError for a damaged archive, a DocumentError for a damaged
 * project.
 * @example
 * const zip = await packProjectArchive(newProject('ball.usda'), new Map([['ball.usda', new Uint8Array([35])]]));
 * const { files } = await openProjectArchive(zip, 'ball.zip');
 * [...files.keys()]; // ['ball.usda']
 */
export async function openProjectArchive(archive: Uint8Array, name: string): Promise<ProjectArchive> {
  const source = await zipSource(memoryFile(archive), name, memorySource({}));
  const folder = `${normalizePath(name)}/`;
  const files = new Map<string, Uint8Array>();
  for (const path of await source.list()) files.set(path.slice(folder.length), (await source.read(path))!);
  const project = files.get(PROJECT_FILE_NAME);
  if (!project)
    throw inputError('zip.no-project', name, msg`it holds no ${PROJECT_FILE_NAME}; export the project again`);
  files.delete(PROJECT_FILE_NAME);
  return { document: parseDocument(new TextDecoder().decode(project)), files };
}
