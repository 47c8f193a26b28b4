import { composeOffsets, inverseOffset, isNoOffset, NO_OFFSET, type TimeOffset } from './offsets.ts';
import { hasPrefix } from './paths.ts';

type Pair = readonly [source: string, target: string];

/**
 * How the namespace of what an arc leads to becomes the namespace of what has the arc: prefixes and what replaces
 * them, the longest first to count; paths under none of them do not map. With it goes how times map.
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
  for (const pair of pairs)
    if (hasPrefix(path, pair[from]) && (!best || pair[from].length > best[from].length)) best = pair;
  if (!best) return undefined;
  const result = best[to] + path.slice(best[from].length);
  const taken = pairs.some((p) => p !== best && p[to].length > best[to].length && hasPrefix(result, p[to]));
  return taken ? undefined : result;
}

/** First `inner`, then `outer`. */
export function composeMaps(outer: NamespaceMap, inner: NamespaceMap): NamespaceMap {
  if (isIdentity(outer)) return inner;
  if (isIdentity(inner)) return outer;
  const bySource = new Map<string, string>();
  for (const [source, middle] of inner.pairs) {
    const target = mapToTarget(outer, middle);
    if (target !== undefined) bySource.set(source, target);
  }
  for (const [middle, target] of outer.pairs) {
    const source = mapToSource(inner, middle);
    if (source !== undefined && !bySource.has(source)) bySource.set(source, target);
  }
  return { pairs: canonical([...bySource]), time: composeOffsets(outer.time, inner.time) };
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

/** Sorted, and without the pairs that say what a shorter one says already. */
function canonical(pairs: readonly Pair[]): Pair[] {
  const sorted = [...pairs].sort((a, b) => a[0].length - b[0].length || (a[0] < b[0] ? -1 : 1));
  const kept: Pair[] = [];
  for (const pair of sorted) if (translate(kept, pair[0], 0) !== pair[1]) kept.push(pair);
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
