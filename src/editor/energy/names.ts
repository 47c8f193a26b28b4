import type { Books } from '../../dynamics/books.ts';
import { simulateNode } from '../../nodes/dynamics/simulate.ts';
import { formatNumber } from '../format.ts';
import type { Run } from '../state/runs.ts';

/** What runs are called: as a person calls the node, else by the method; where that is the same, also by the speed of light, or the node. */
export function namesOf(
  runs: readonly Run[],
  titleOf: (node: string) => string | undefined,
  word: (key: string) => string,
): string[] {
  const short = runs.map(({ node, books }) => titleOf(node) ?? methodOf(books, word));
  const lit = runs.map(({ books }, i) => `${short[i]}, c = ${formatNumber(books.speedOfLight, 1)} m/s`);
  return runs.map(({ node }, i) => {
    const alone = [short, lit].find((names) => names.indexOf(names[i]!) === names.lastIndexOf(names[i]!));
    return alone?.[i] ?? `${short[i]} (${node})`;
  });
}

/** With its correction, where it has several. */
function methodOf({ method, onGpu }: Books, word: (key: string) => string): string {
  const [, family, correction] = /^(.+?)(?:-([0-3]))?$/.exec(method) ?? [];
  const known = simulateNode.params.method.options.find(({ value }) => value === family);
  return [word(known?.title ?? method), correction, onGpu && 'GPU'].filter(Boolean).join(' ');
}
