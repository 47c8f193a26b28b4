import { renameFiles } from '../../graph/document/fileReferences.ts';
import { readDocument } from '../../graph/document/parse.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { type LocalFiles, parseLocalName } from '../loading/localFiles.ts';
import type { LoadedProject } from '../state/editor.ts';
import type { SessionFiles, SessionRecord } from './sessionStore.ts';

/**
 * Restores a stored session into this one: file sets keep their ids unless these are taken. Throws a DocumentError if
 * the document cannot be read.
 */
export function restoreSession(session: SessionRecord, files: SessionFiles, local: LocalFiles): LoadedProject {
  const document = readDocument(session.document);
  const keys = new Map([...files].map(([id, set]) => [id, local.restoreSet(id, set)]));
  const renamed = (name: string): string => {
    const { id, rest } = parseLocalName(name) ?? {};
    if (id === undefined) return name;
    if (!keys.has(id)) local.reserveName(name);
    return `local:${keys.get(id) ?? id}${rest}`;
  };
  return {
    document: renameFiles(document, nodeLibrary, renamed),
    origin: renamed(session.origin),
    unsaved: session.unsaved,
  };
}
