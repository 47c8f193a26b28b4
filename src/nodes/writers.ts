import { type GraphDocument, own } from '../graph/document.ts';
import type { Evaluation } from '../graph/evaluate.ts';
import { flatten } from '../graph/flatten.ts';
import type { ProjectFile } from './files.ts';
import { nodeLibrary } from './library.ts';

/** The output of a node of that type that asks for a file. */
const fileOutput = (type: string): string | undefined =>
  Object.entries(own(nodeLibrary, type)?.outputs ?? {}).find(([, socket]) => socket.type === 'file')?.[0];

/** Whether nodes of that type ask for files. */
export const writes = (type: string): boolean => fileOutput(type) !== undefined;

/** The nodes of a project that ask for files, by their types: groups opened out, muted ones left out. Throws a DocumentError. */
export function writersIn(document: GraphDocument): ReadonlyMap<string, string> {
  const flat = [...flatten(document, nodeLibrary).nodes.values()];
  return new Map(flat.filter(({ type }) => fileOutput(type)).map(({ id, type }) => [id, type]));
}

/** What the writers ask for, of those that an evaluation got to. */
export function filesOf(
  { results }: Evaluation,
  writers: ReadonlyMap<string, string>,
): ReadonlyMap<string, ProjectFile> {
  return new Map(
    [...writers].flatMap(([id, type]) => {
      const result = results.get(id);
      return result?.status === 'done' ? [[id, result.outputs[fileOutput(type)!] as ProjectFile] as const] : [];
    }),
  );
}
