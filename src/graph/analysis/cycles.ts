/**
 * Nodes in cycles, or between cycles: what remains after repeatedly removing nodes without predecessors or without
 * successors. `before`: predecessors of each node.
 */
export function nodesInCycles(before: ReadonlyMap<string, readonly string[]>): ReadonlySet<string> {
  const after = new Map<string, string[]>([...before.keys()].map((id) => [id, []]));
  for (const [id, sources] of before) for (const source of sources) after.get(source)?.push(id);
  const left = new Set(before.keys());
  removeUnconstrained(left, before, after);
  removeUnconstrained(left, after, before);
  return left;
}

type NeighborMap = ReadonlyMap<string, readonly string[]>;

/** Removes nodes without remaining `needed` neighbours until all have one. */
function removeUnconstrained(left: Set<string>, needed: NeighborMap, needing: NeighborMap): void {
  const counts = new Map<string, number>();
  for (const id of left) counts.set(id, needed.get(id)!.filter((other) => left.has(other)).length);
  const free = [...left].filter((id) => counts.get(id) === 0);
  for (let id = free.pop(); id !== undefined; id = free.pop()) {
    left.delete(id);
    for (const other of needing.get(id)!) {
      if (!left.has(other)) continue;
      const count = counts.get(other)! - 1;
      counts.set(other, count);
      if (count === 0) free.push(other);
    }
  }
}
