import type { Span } from '../../scene/compose/paths.ts';
import { refusal } from '../geometry/shared.ts';

export function checkSpan({ from, to }: Span, node: string): void {
  if (to > from) return;
  const remedy = { node, param: 'to', value: from + 10 };
  throw refusal('motion.span', `${node}.to`, `it ends at ${to} s, before it begins at ${from} s`, remedy);
}

/** Most turns of a motion: each takes some hundred samples. */
const MOST_TURNS = 1000;

export function checkTurns(rate: number, { from, to }: Span, node: string): void {
  const turns = (Math.abs(rate) * (to - from)) / (2 * Math.PI);
  if (turns <= MOST_TURNS) return;
  const message = `it would turn ${turns.toExponential(1)} times, more than ${MOST_TURNS}; let it be slower, or end sooner`;
  const remedy = { node, param: 'to', value: from + ((to - from) * MOST_TURNS) / turns };
  throw refusal('motion.turns', `${node}.to`, message, remedy);
}
