import { composeOffsets, inverseOffset, isNoOffset, NO_OFFSET, type TimeOffset } from './offsets.ts';
import { hasPrefix } from './paths.ts';

/** One side is missing where what is under the other maps nowhere. */
type Pair = readonly [source: string | undefined, target: string | undefined];

/**
 * How the namespace of what an arc leads to becomes the namespace of what has the arc: prefixes and what replaces
 * them, the longest counts; paths under none of them do not map. With it goes how times map.
 */
export interface NamespaceMap {
  readonly pairs: readonly Pair[];
  readonly time: TimeOffset;
}

const ROOT: Pair = ['', ''];

export const IDENTITY: NamespaceMap = { pairs: [ROOT], time: NO_OFFSET };

export const isIdentity = ({ pairs, time }: NamespaceMap): boolean =>
  pairs.length === 1 && pairs[0][0] === '' && pairs[0][1] === '' && isNoOffset(time);

export const arcMap = (source: string, target: string, time: TimeOffset): NamespaceMap => ({
  pairs: [[source, target]],
  time,
});

export const mapToTarget = (map: NamespaceMap, path: string): string | undefined => translate(map.pairs, path, 0);
export const mapToSource = (map: NamespaceMap, path: string): string | undefined => translate(map.pairs, path, 1);

/** Undefined where no pair covers the path, or where the result belongs to another, closer pair. */
function translate(pairs: readonly Pair[], path: string, from: 0 | 1): string | undefined {
  const to = from === 0 ? 1 : 0;
  let best: Pair | undefined;
  let covered = -1;
  for (const pair of pairs) {
    const prefix = pair[from];
    if (prefix === undefined || prefix.length <= covered || !hasPrefix(path, prefix)) continue;
    best = pair;
    covered = prefix.length;
  }
  const replaced = best?.[to];
  if (replaced === undefined) return undefined;
  const result = replaced + path.slice(covered);
  const isTaken = ({ [to]: other }: Pair): boolean =>
    other !== undefined && other.length > replaced.length && hasPrefix(result, other);
  return pairs.some((pair) => pair !== best && isTaken(pair)) ? undefined : result;
}

/** First `inner`, then `outer`. */
export function composeMaps(outer: NamespaceMap, inner: NamespaceMap): NamespaceMap {
  if (isIdentity(outer)) return inner;
  if (isIdentity(inner)) return outer;
  const through = (path: string | undefined, first: NamespaceMap, then: NamespaceMap, from: 0 | 1) => {
    const middle = path === undefined ? undefined : translate(first.pairs, path, from);
    return middle === undefined ? undefined : translate(then.pairs, middle, from);
  };
  const sources = [...inner.pairs.map((p) => p[0]), ...outer.pairs.map((p) => p[0] && mapToSource(inner, p[0]))];
  const targets = [...outer.pairs.map((p) => p[1]), ...inner.pairs.map((p) => p[1] && mapToTarget(outer, p[1]))];
  const pairs: Pair[] = [];
  for (const source of new Set(sources))
    if (source !== undefined) pairs.push([source, through(source, inner, outer, 0)]);
  for (const target of new Set(targets))
    if (target !== undefined) pairs.push([through(target, outer, inner, 1), target]);
  return { pairs: canonical(pairs), time: composeOffsets(outer.time, inner.time) };
}

export const inverseMap = ({ pairs, time }: NamespaceMap): NamespaceMap => ({
  pairs: pairs.map(([source, target]): Pair => [target, source]),
  time: inverseOffset(time),
});

/** What lies outside of an arc keeps its path: of classes, and of references within one layer. */
export function withRoot(map: NamespaceMap): NamespaceMap {
  if (map.pairs.some(([source, target]) => source === '' || target === '')) return map;
  return { ...map, pairs: canonical([ROOT, ...map.pairs]) };
}

export const withPairs = (map: NamespaceMap, more: readonly Pair[]): NamespaceMap => ({
  ...map,
  pairs: canonical([...map.pairs, ...more]),
});

/** Sorted, and without the pairs that say what shorter ones say already. */
function canonical(pairs: readonly Pair[]): Pair[] {
  const lengthOf = ([source, target]: Pair): number => (source ?? target ?? '').length;
  const textOf = ([source, target]: Pair): string => `${source ?? ' '}\n${target ?? ' '}`;
  const sorted = [...pairs].sort((a, b) => lengthOf(a) - lengthOf(b) || (textOf(a) < textOf(b) ? -1 : 1));
  const kept: Pair[] = [];
  for (const pair of sorted) {
    const [source, target] = pair;
    const known =
      source === undefined ? translate(kept, target ?? '', 1) === undefined : translate(kept, source, 0) === target;
    if (!known) kept.push(pair);
  }
  return kept;
}

export function sameMaps(a: NamespaceMap, b: NamespaceMap): boolean {
  return (
    a.pairs.length === b.pairs.length &&
    a.time.offset === b.time.offset &&
    a.time.scale === b.time.scale &&
    a.pairs.every(([source, target], i) => source === b.pairs[i][0] && target === b.pairs[i][1])
  );
}
