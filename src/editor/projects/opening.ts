import { inputError, messageOf } from '../../formats/fail.ts';
import { nearestPath } from '../../formats/find.ts';
import { resolvePath } from '../../formats/source.ts';
import { DocumentError, type GraphDocument } from '../../graph/document.ts';
import { withFiles } from '../../graph/files.ts';
import { parseDocument } from '../../graph/read.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { InputError } from '../../scene/types.ts';
import { type HeldFile, type HeldFiles, readHeld, withArchives } from '../loading/held.ts';
import type { LocalFiles } from '../loading/localFiles.ts';
import type { Beginning } from '../state/studio.ts';
import { insideName, outsideName, projectIn } from './names.ts';

/** Beyond this a file is no project, whatever it is called [bytes]. */
const MOST_BYTES = 2 ** 26;

/** A project that could not be opened: where, and why. */
export interface OpeningProblem {
  readonly place?: string;
  readonly text: string;
}

/** What is told of a project that could not be opened; `name`: its file. */
export function openingProblem(name: string, thrown: unknown): OpeningProblem {
  if (thrown instanceof InputError) return { place: thrown.diagnostic.place, text: thrown.diagnostic.message };
  const text = messageOf(thrown);
  return {
    place: name,
    text:
      thrown instanceof DocumentError ? `${text}. Save the project again, or undo what was changed in its text.` : text,
  };
}

/** What is told of a link that could not be opened; its message names it. */
export const linkProblem = (thrown: unknown): OpeningProblem => ({ text: messageOf(thrown) });

/**
 * A project among files that a person gave. The files that it names are looked for beside it, then anywhere among these, then among those
 * of this session; the others are left to be found beside the page. Throws an InputError or a DocumentError.
 */
export async function projectFrom(files: HeldFiles, path: string, local: LocalFiles): Promise<Beginning> {
  const document = parseDocument(await textOf(path, files.get(path)!));
  const origin = local.add(files, path);
  const found = (name: string): string => {
    const plain = outsideName(name, origin);
    const beside = insideName(path, plain);
    const held = files.has(beside) ? beside : nearestPath(files.keys(), plain);
    return held === undefined ? (local.find(plain) ?? plain) : local.sibling(origin, held);
  };
  return { document: withFiles(document, nodeLibrary, found), origin, unsaved: false };
}

/** A project, or a zip that holds one, at an address; its files are beside it. Throws as `projectFrom`, and where the server has none. */
export async function projectAt(address: string, local: LocalFiles): Promise<Beginning> {
  const response = await fetch(new URL(address, document.baseURI));
  const name = address.slice(address.lastIndexOf('/') + 1);
  if (!response.ok) throw inputError('file.missing', name, `the server answers ${response.status}; check the address`);
  const file = await response.blob();
  if (!/\.zip$/i.test(name))
    return {
      document: besideAddress(parseDocument(await textOf(name, file)), address),
      origin: address,
      unsaved: false,
    };
  const files = await withArchives(new Map([[name, file]]));
  return projectFrom(files, projectAmong(files, name), local);
}

/** Throws an InputError where there is none. */
function projectAmong(files: HeldFiles, name: string): string {
  const path = projectIn([...files.keys()]);
  if (path === undefined)
    throw inputError('zip.no-project', name, 'it holds no .slowlight.json; save the project with its files again');
  return path;
}

const besideAddress = (project: GraphDocument, address: string): GraphDocument =>
  withFiles(project, nodeLibrary, (name) => {
    if (/^[a-z]+:/i.test(name)) return name;
    return /^[a-z]+:/i.test(address) ? new URL(name, address).href : resolvePath(address, name);
  });

async function textOf(name: string, file: HeldFile): Promise<string> {
  const size = file instanceof Blob ? file.size : file.entry.size;
  if (size > MOST_BYTES)
    throw inputError('file.too-large', name, `${size} bytes are more than a project has; it holds words, not data`);
  return new TextDecoder().decode(await readHeld(file, () => {}));
}
