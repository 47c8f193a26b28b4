import { inputError } from '../formats/fail.ts';
import { memorySource, normalizePath } from '../formats/source.ts';
import { packZip } from '../formats/zip/pack.ts';
import { bytesFile, zipSource } from '../formats/zip/source.ts';
import type { FileReference, GraphDocument } from '../graph/document.ts';
import { filesIn } from '../graph/files.ts';
import { parseDocument } from '../graph/read.ts';
import { serializeDocument } from '../graph/serialize.ts';
import { nodeLibrary } from './library.ts';

/** What a project is called in its archive. */
export const PROJECT = 'project.slowlight.json';

/**
 * A project with its files, as one zip. `files`: by the names under which the document refers to them, with what they refer to
 * themselves (textures, layers) beside them.
 */
export async function packProject(
  document: GraphDocument,
  files: ReadonlyMap<string, Uint8Array>,
): Promise<Uint8Array> {
  const missing = filesIn(document, nodeLibrary).find((file) => !files.has(file));
  if (missing !== undefined)
    throw inputError('file.missing', missing, 'the project reads it; open it again before the project is packed');
  const references = await Promise.all(
    [...files].map(async ([path, bytes]) => [path, await referenceTo(bytes)] as const),
  );
  const text = serializeDocument({ ...document, files: Object.fromEntries(references) });
  return packZip(new Map([[PROJECT, new TextEncoder().encode(text)], ...files]));
}

async function referenceTo(bytes: Uint8Array): Promise<FileReference> {
  // A page that is served without encryption has none.
  if (!crypto.subtle) return { size: bytes.length };
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes.slice()));
  return { size: bytes.length, hash: [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('') };
}

export interface OpenedProject {
  readonly document: GraphDocument;
  /** The project's files, by the names under which the document refers to them. */
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/** Reads what `packProject` made. Throws an InputError of a damaged archive, a DocumentError of a damaged project. */
export async function openProject(archive: Uint8Array, name: string): Promise<OpenedProject> {
  const source = await zipSource(bytesFile(archive), name, memorySource({}));
  const folder = `${normalizePath(name)}/`;
  const files = new Map<string, Uint8Array>();
  for (const path of await source.list()) files.set(path.slice(folder.length), (await source.read(path))!);
  const project = files.get(PROJECT);
  if (!project) throw inputError('zip.no-project', name, `it holds no ${PROJECT}; export the project again`);
  files.delete(PROJECT);
  return { document: parseDocument(new TextDecoder().decode(project)), files };
}
