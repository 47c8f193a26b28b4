import type { Books } from '../../dynamics/books.ts';
import type { GraphDocument } from '../../graph/document.ts';
import type { Evaluation } from '../../graph/evaluate.ts';

/** The books of a node's run. */
export interface Run {
  /** As evaluations name the node. */
  readonly node: string;
  readonly books: Books;
  /** It was not computed to its end: there is more to come, or it was stopped by a person. */
  readonly interim: boolean;
}

/** The books of all runs in an evaluation; what others pass on counts where it was made. */
export function runsIn(results: Evaluation['results']): Run[] {
  const runs = new Map<unknown, Run>();
  for (const [node, result] of results) {
    if (result.status !== 'done' || !isBooks(result.outputs.books) || runs.has(result.outputs.books)) continue;
    runs.set(result.outputs.books, { node, books: result.outputs.books, interim: result.interim ?? false });
  }
  return [...runs.values()];
}

/** Simulate nodes, outside of groups, that an evaluation did not come to: nothing that was asked for is made of them. */
export const unseenIn = ({ nodes }: GraphDocument, results: Evaluation['results']): string[] =>
  Object.keys(nodes).filter((node) => nodes[node]!.type === 'simulate' && !results.has(node));

const isBooks = (value: unknown): value is Books => typeof value === 'object' && value !== null && 'kinetic' in value;

/** Of what is still computed, until when there is something [s]. */
export const computedUntil = (results: Evaluation['results']): number =>
  Math.min(...runsIn(results).flatMap(({ interim, books }) => (interim ? [books.times.at(-1) ?? 0] : [])));
