import { withFiles } from '../../graph/files.ts';
import { readDocument } from '../../graph/read.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { type LocalFiles, localParts } from '../loading/localFiles.ts';
import type { Beginning } from '../state/studio.ts';
import type { KeptFiles, KeptSession } from './sessions.ts';

/**
 * Takes what was kept of a session into this one: sets of files under their keys, or under others where these are taken. Throws a
 * DocumentError where the document cannot be read.
 */
export function adopted(session: KeptSession, files: KeptFiles, local: LocalFiles): Beginning {
  const document = readDocument(session.document);
  const keys = new Map([...files].map(([id, set]) => [id, local.adopt(id, set)]));
  const renamed = (name: string): string => {
    const { id, rest } = localParts(name) ?? {};
    if (id === undefined) return name;
    if (!keys.has(id)) local.reserve(name);
    return `local:${keys.get(id) ?? id}${rest}`;
  };
  return {
    document: withFiles(document, nodeLibrary, renamed),
    origin: renamed(session.origin),
    unsaved: session.unsaved,
  };
}
