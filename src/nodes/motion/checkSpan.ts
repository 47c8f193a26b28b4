import { msg } from '../../messages/message.ts';
import type { TimeSpan } from '../../scene/compose/motionPaths.ts';
import { nodeRefusal } from '../common/params.ts';

export function assertTimeSpan({ from, to }: TimeSpan, node: string): void {
  if (to > from) return;
  const remedy = { node, param: 'to', value: from + 10 };
  throw nodeRefusal('motion.span', `${node}.to`, msg`it ends at ${to} s, before it begins at ${from} s`, remedy);
}

/** Maximum number of turns; each takes some hundred samples. */
const MAX_TURNS = 1000;

export function assertTurns(rate: number, { from, to }: TimeSpan, node: string): void {
  const turns = (Math.abs(rate) * (to - from)) / (2 * Math.PI);
  if (turns <= MAX_TURNS) return;
  const message = msg`it would turn ${turns.toExponential(1)} times, more than ${MAX_TURNS}; let it be slower, or end sooner`;
  const remedy = { node, param: 'to', value: from + ((to - from) * MAX_TURNS) / turns };
  throw nodeRefusal('motion.turns', `${node}.to`, message, remedy);
}
