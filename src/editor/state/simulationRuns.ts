import type { RunRecord } from '../../dynamics/runRecord.ts';
import type { GraphDocument } from '../../graph/document/document.ts';
import type { Evaluation } from '../../graph/evaluation/evaluator.ts';

/** The books of a node's run. */
export interface SimulationRun {
  /** As evaluations name the node. */
  readonly node: string;
  readonly record: RunRecord;
  /** It was not computed to its end: there is more to come, or it was stopped by a person. */
  readonly interim: boolean;
}

/** The books of all runs in an evaluation; what others pass on counts where it was made. */
export function simulationRuns(results: Evaluation['results']): SimulationRun[] {
  const runs = new Map<unknown, SimulationRun>();
  for (const [node, result] of results) {
    if (result.status !== 'done' || !isRunRecord(result.outputs.books) || runs.has(result.outputs.books)) continue;
    runs.set(result.outputs.books, { node, record: result.outputs.books, interim: result.interim ?? false });
  }
  return [...runs.values()];
}

/** Simulate nodes, outside of groups, that an evaluation did not come to: nothing that was asked for is made of them. */
export const unevaluatedSimulations = ({ nodes }: GraphDocument, results: Evaluation['results']): string[] =>
  Object.keys(nodes).filter((node) => nodes[node]!.type === 'simulate' && !results.has(node));

const isRunRecord = (value: unknown): value is RunRecord =>
  typeof value === 'object' && value !== null && 'kinetic' in value;

/** Of what is still computed, until when there is something [s]. */
export const computedUntil = (results: Evaluation['results']): number =>
  Math.min(...simulationRuns(results).flatMap(({ interim, record }) => (interim ? [record.times.at(-1) ?? 0] : [])));
