import type { RunRecord } from '../../dynamics/runRecord.ts';
import type { GraphDocument } from '../../graph/document/document.ts';
import type { Evaluation } from '../../graph/evaluation/evaluator.ts';

/** The run record of a simulate node. */
export interface SimulationRun {
  /** Evaluation id of the node. */
  readonly node: string;
  readonly record: RunRecord;
  /** Whether the run is incomplete: still being computed, or stopped by the user. */
  readonly interim: boolean;
}

/** Run records in an evaluation; each counts once, at the node that made it. */
export function simulationRuns(results: Evaluation['results']): SimulationRun[] {
  const runs = new Map<unknown, SimulationRun>();
  for (const [node, result] of results) {
    if (result.status !== 'done' || !isRunRecord(result.outputs.books) || runs.has(result.outputs.books)) continue;
    runs.set(result.outputs.books, { node, record: result.outputs.books, interim: result.interim ?? false });
  }
  return [...runs.values()];
}

/** Top-level simulate nodes that were not evaluated, since no requested output needs them. */
export const unevaluatedSimulations = ({ nodes }: GraphDocument, results: Evaluation['results']): string[] =>
  Object.keys(nodes).filter((node) => nodes[node]!.type === 'simulate' && !results.has(node));

const isRunRecord = (value: unknown): value is RunRecord =>
  typeof value === 'object' && value !== null && 'kinetic' in value;

/** Time up to which the run in progress is computed [s]. */
export const computedUntil = (results: Evaluation['results']): number =>
  Math.min(...simulationRuns(results).flatMap(({ interim, record }) => (interim ? [record.times.at(-1) ?? 0] : [])));
