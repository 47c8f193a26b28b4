import { hasPrefix } from '../../layer/primPaths.ts';
import { composeOffsets, inverseOffset, isNoOffset, NO_OFFSET, type TimeOffset } from '../layers/timeOffset.ts';

/** A missing side blocks the prefix: it maps nowhere. */
type PathPair = readonly [source: string | undefined, target: string | undefined];

/** Maps an arc's target namespace to its source namespace by path prefixes, longest match; other paths do not map. Also maps times. */
export interface NamespaceMap {
  readonly pairs: readonly PathPair[];
  readonly time: TimeOffset;
}

const ROOT: PathPair = ['', ''];

export const IDENTITY: NamespaceMap = { pairs: [ROOT], time: NO_OFFSET };

export const isIdentity = ({ pairs, time }: NamespaceMap): boolean =>
  pairs.length === 1 && pairs[0][0] === '' && pairs[0][1] === '' && isNoOffset(time);

export const arcMap = (source: string, target: string, time: TimeOffset): NamespaceMap => ({
  pairs: [[source, target]],
  time,
});

export const mapToTarget = (map: NamespaceMap, path: string): string | undefined => translate(map.pairs, path, 0);
export const mapToSource = (map: NamespaceMap, path: string): string | undefined => translate(map.pairs, path, 1);

const translate = (pairs: readonly PathPair[], path: string, from: 0 | 1): string | undefined =>
  translateBy(pairs.length > MAX_LINEAR_PAIRS ? pairIndexOf(pairs) : new LinearPairLookup(pairs), path, from);

/** Undefined if no prefix matches, or if the result is under a closer pair. */
function translateBy(pairs: PairLookup, path: string, from: 0 | 1): string | undefined {
  const to = from === 0 ? 1 : 0;
  const best = pairs.closest(path, from);
  const replaced = best?.[to];
  if (replaced === undefined) return undefined;
  const result = replaced + path.slice(best![from]!.length);
  return pairs.closest(result, to)![to]!.length > replaced.length ? undefined : result;
}

/** Finds the longest prefix match of a path. */
interface PairLookup {
  closest(path: string, side: 0 | 1): PathPair | undefined;
}

class LinearPairLookup implements PairLookup {
  private readonly pairs: readonly PathPair[];

  constructor(pairs: readonly PathPair[]) {
    this.pairs = pairs;
  }

  closest(path: string, side: 0 | 1): PathPair | undefined {
    let best: PathPair | undefined;
    let covered = -1;
    for (const pair of this.pairs) {
      const prefix = pair[side];
      if (prefix === undefined || prefix.length <= covered || !hasPrefix(path, prefix)) continue;
      best = pair;
      covered = prefix.length;
    }
    return best;
  }
}

/** Above this number of pairs a hash map is used: relocates can add any number. */
const MAX_LINEAR_PAIRS = 6;
const indices = new WeakMap<readonly PathPair[], HashedPairLookup>();

function pairIndexOf(pairs: readonly PathPair[]): HashedPairLookup {
  const known = indices.get(pairs);
  if (known) return known;
  const index = new HashedPairLookup();
  for (const pair of pairs) index.add(pair);
  indices.set(pairs, index);
  return index;
}

class HashedPairLookup implements PairLookup {
  private readonly sides = [new Map<string, PathPair>(), new Map<string, PathPair>()] as const;

  add(pair: PathPair): void {
    for (const side of [0, 1] as const) {
      const prefix = pair[side];
      if (prefix !== undefined && !this.sides[side].has(prefix)) this.sides[side].set(prefix, pair);
    }
  }

  closest(path: string, side: 0 | 1): PathPair | undefined {
    const index = this.sides[side];
    let found = index.get(path);
    for (let i = path.length - 1; !found && i >= 0; i--)
      if (SEPARATORS.has(path.charCodeAt(i))) found = index.get(path.slice(0, i));
    return found;
  }
}

/** Characters that may follow a prefix. */
const SEPARATORS: ReadonlySet<number> = new Set([47, 46, 123]);

/** First `inner`, then `outer`. */
export function composeMaps(outer: NamespaceMap, inner: NamespaceMap): NamespaceMap {
  if (isIdentity(outer)) return inner;
  if (isIdentity(inner)) return outer;
  const time = composeOffsets(outer.time, inner.time);
  const single =
    inner.pairs.length === 1 && outer.pairs.length === 1 && composeSingle(outer.pairs[0], inner.pairs[0], time);
  if (single) return single;
  const through = (path: string | undefined, first: NamespaceMap, then: NamespaceMap, from: 0 | 1) => {
    const middle = path === undefined ? undefined : translate(first.pairs, path, from);
    return middle === undefined ? undefined : translate(then.pairs, middle, from);
  };
  const sources = [...inner.pairs.map((p) => p[0]), ...outer.pairs.map((p) => p[0] && mapToSource(inner, p[0]))];
  const targets = [...outer.pairs.map((p) => p[1]), ...inner.pairs.map((p) => p[1] && mapToTarget(outer, p[1]))];
  const pairs: PathPair[] = [];
  for (const source of new Set(sources))
    if (source !== undefined) pairs.push([source, through(source, inner, outer, 0)]);
  for (const target of new Set(targets))
    if (target !== undefined) pairs.push([through(target, outer, inner, 1), target]);
  return { pairs: canonicalPairs(pairs), time };
}

/** Fast path: both maps have one pair. */
function composeSingle(
  [start, target]: PathPair,
  [source, between]: PathPair,
  time: TimeOffset,
): NamespaceMap | undefined {
  if (source === undefined || between === undefined || target === undefined || start === undefined) return undefined;
  return hasPrefix(between, start) ? { pairs: [[source, target + between.slice(start.length)]], time } : undefined;
}

export const inverseMap = ({ pairs, time }: NamespaceMap): NamespaceMap => ({
  pairs: inversePairs(pairs),
  time: inverseOffset(time),
});

/** Inverses of long maps, cached: they are needed per class. */
const inverses = new WeakMap<readonly PathPair[], readonly PathPair[]>();

function inversePairs(pairs: readonly PathPair[]): readonly PathPair[] {
  const known = inverses.get(pairs);
  if (known) return known;
  const made = pairs.map(([source, target]): PathPair => [target, source]);
  if (pairs.length > MAX_LINEAR_PAIRS) inverses.set(pairs, made);
  return made;
}

/** Adds the identity for paths outside the arc: for classes and internal references. */
export function withRoot(map: NamespaceMap): NamespaceMap {
  if (map.pairs.some(([source, target]) => source === '' || target === '')) return map;
  if (map.pairs.length === 1) {
    const [[source, target]] = map.pairs;
    return { ...map, pairs: source === target ? IDENTITY.pairs : [ROOT, map.pairs[0]] };
  }
  return { ...map, pairs: canonicalPairs([ROOT, ...map.pairs]) };
}

export const withPairs = (map: NamespaceMap, more: readonly PathPair[]): NamespaceMap => ({
  ...map,
  pairs: canonicalPairs([...map.pairs, ...more]),
});

/** Blocked pairs sort after the root ('') and before paths. */
function compare(a = ' ', b = ' '): number {
  return a === b ? 0 : a < b ? -1 : 1;
}

/** Sorted, without pairs implied by shorter ones. */
function canonicalPairs(pairs: readonly PathPair[]): readonly PathPair[] {
  if (pairs.length === 1) return pairs;
  const lengthOf = ([source, target]: PathPair): number => (source ?? target ?? '').length;
  const sorted = [...pairs].sort((a, b) => lengthOf(a) - lengthOf(b) || compare(a[0], b[0]) || compare(a[1], b[1]));
  const kept: PathPair[] = [];
  const index = new HashedPairLookup();
  const lookup: PairLookup = pairs.length > MAX_LINEAR_PAIRS ? index : new LinearPairLookup(kept);
  for (const pair of sorted) {
    const [source, target] = pair;
    const known =
      source === undefined
        ? translateBy(lookup, target ?? '', 1) === undefined
        : translateBy(lookup, source, 0) === target;
    if (known) continue;
    kept.push(pair);
    if (lookup === index) index.add(pair);
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
