import { inputError } from '../../formats/diagnostics/inputError.ts';
import { resolvePath } from '../../formats/files/fileSource.ts';
import { nearestPath } from '../../formats/files/nearestPath.ts';
import { DocumentError, type GraphDocument } from '../../graph/document/document.ts';
import { renameFiles } from '../../graph/document/fileReferences.ts';
import { parseDocument } from '../../graph/document/parse.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { InputError } from '../../scene/types.ts';
import { fetchFile } from '../loading/fetchFile.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import { expandArchives, readUserFile, type UserFile, type UserFiles } from '../loading/userFiles.ts';
import type { LoadedProject } from '../state/editor.ts';
import { exportedName, findProject, importedPath } from './projectNames.ts';

/** Larger files are not read as projects [bytes]. */
const MAX_PROJECT_BYTES = 2 ** 26;

/** Why a project could not be opened, and where the error is. */
export interface OpenError {
  readonly place?: LocalizedText;
  readonly text: LocalizedText;
}

/** Describes an error on opening the project file `name`. */
export function openErrorOf(name: string, thrown: unknown): OpenError {
  if (thrown instanceof InputError) return { place: thrown.diagnostic.place, text: thrown.diagnostic.message };
  const text = messageOf(thrown);
  return {
    place: name,
    text:
      thrown instanceof DocumentError
        ? msg`${text}. Save the project again, or undo what was changed in its text.`
        : text,
  };
}

/** Describes an error on opening a link. */
export const linkErrorOf = (thrown: unknown): OpenError => ({ text: messageOf(thrown) });

/**
 * Reads a project among files from the user. The files that it references are searched beside it, then among all given
 * files, then in this session; others are expected beside the page. Throws an InputError or a DocumentError.
 */
export async function projectFromFiles(files: UserFiles, path: string, local: LocalFiles): Promise<LoadedProject> {
  const document = parseDocument(await readText(path, files.get(path)!));
  const origin = local.add(files, path);
  const found = (name: string): string => {
    const plain = exportedName(name, origin);
    const beside = importedPath(path, plain);
    const held = files.has(beside) ? beside : nearestPath(files.keys(), plain);
    return held === undefined ? (local.find(plain) ?? plain) : local.sibling(origin, held);
  };
  return { document: renameFiles(document, nodeLibrary, found), origin, unsaved: false };
}

/**
 * Reads a project, or a zip that contains one, at an address, with files beside it. Throws as `projectFromFiles`, and
 * if the server does not have it.
 */
export async function projectFromAddress(address: string, local: LocalFiles): Promise<LoadedProject> {
  const name = address.slice(address.lastIndexOf('/') + 1);
  const response = await fetchFile(new URL(address, document.baseURI), name);
  if (!response.ok)
    throw inputError('file.missing', name, msg`the server answers ${response.status}; check the address`);
  const file = await response.blob();
  if (!/\.zip$/i.test(name))
    return {
      document: resolveFileNames(parseDocument(await readText(name, file)), address),
      origin: address,
      unsaved: false,
    };
  const files = await expandArchives(new Map([[name, file]]));
  return projectFromFiles(files, findProjectFile(files, name), local);
}

/** Throws an InputError if there is none. */
function findProjectFile(files: UserFiles, name: string): string {
  const path = findProject([...files.keys()]);
  if (path === undefined)
    throw inputError('zip.no-project', name, msg`it holds no .slowlight.json; save the project with its files again`);
  return path;
}

const resolveFileNames = (project: GraphDocument, address: string): GraphDocument =>
  renameFiles(project, nodeLibrary, (name) => {
    if (/^[a-z]+:/i.test(name)) return name;
    return /^[a-z]+:/i.test(address) ? new URL(name, address).href : resolvePath(address, name);
  });

async function readText(name: string, file: UserFile): Promise<string> {
  const size = file instanceof Blob ? file.size : file.entry.size;
  if (size > MAX_PROJECT_BYTES)
    throw inputError('file.too-large', name, msg`${size} bytes are more than a project has; it holds words, not data`);
  return new TextDecoder().decode(await readUserFile(file, () => {}));
}
