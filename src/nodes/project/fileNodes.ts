import { flatten } from '../../graph/analysis/flatten.ts';
import { type GraphDocument, own } from '../../graph/document/document.ts';
import type { Evaluation } from '../../graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../library.ts';
import type { RequestedFile } from './outputFiles.ts';

/** The output of a node type that requests a file. */
const fileOutputOf = (type: string): string | undefined =>
  Object.entries(own(nodeLibrary, type)?.outputs ?? {}).find(([, socket]) => socket.type === 'file')?.[0];

/** Whether a node type requests files. */
export const isFileNode = (type: string): boolean => fileOutputOf(type) !== undefined;

/**
 * The nodes of a project that request files, with their types: groups expanded, muted nodes skipped. Throws a
 * DocumentError.
 */
export function fileNodesIn(document: GraphDocument): ReadonlyMap<string, string> {
  const flat = [...flatten(document, nodeLibrary).nodes.values()];
  return new Map(flat.filter(({ type }) => fileOutputOf(type)).map(({ id, type }) => [id, type]));
}

/** Requested files of an evaluation's results. */
export function requestedFiles(
  { results }: Evaluation,
  writers: ReadonlyMap<string, string>,
): ReadonlyMap<string, RequestedFile> {
  return new Map(
    [...writers].flatMap(([id, type]) => {
      const result = results.get(id);
      return result?.status === 'done' ? [[id, result.outputs[fileOutputOf(type)!] as RequestedFile] as const] : [];
    }),
  );
}
