import type { RunRecord } from '../../dynamics/runRecord.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { simulateNode } from '../../nodes/dynamics/simulate.ts';
import { formatNumber } from '../format.ts';
import type { SimulationRun } from '../state/simulationRuns.ts';

/**
 * Display names of runs: the user's node title, else the method; duplicates are told apart by the speed of light, then
 * by the node id.
 */
export function runNames(
  runs: readonly SimulationRun[],
  titleOf: (node: string) => string | undefined,
  t: (text: LocalizedText) => string,
): string[] {
  const short = runs.map(({ node, record }) => titleOf(node) ?? methodName(record, t));
  const withSpeedOfLight = runs.map(({ record }, i) =>
    t(msg`${short[i]!}, c = ${formatNumber(record.speedOfLight, 1)} m/s`),
  );
  return runs.map(({ node }, i) => {
    const alone = [short, withSpeedOfLight].find((names) => names.indexOf(names[i]!) === names.lastIndexOf(names[i]!));
    return alone?.[i] ?? `${short[i]} (${node})`;
  });
}

/** With its velocity correction, for methods that have several. */
function methodName({ method, onGpu }: RunRecord, t: (text: LocalizedText) => string): string {
  const [, family, correction] = /^(.+?)(?:-([0-3]))?$/.exec(method) ?? [];
  const known = simulateNode.params.method.options.find(({ value }) => value === family);
  return [t(known?.title ?? method), correction, onGpu && 'GPU'].filter(Boolean).join(' ');
}
