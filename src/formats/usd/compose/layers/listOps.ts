import type { ListOp } from '../../layer/layer.ts';

/** Applies a list op: deleted, added, prepended, appended and reordered items, in this order (SdfListOp). `keyOf`: identity of items. */
export function applyListOp<T>(list: readonly T[], op: ListOp<T>, keyOf: (item: T) => string): T[] {
  if (op.explicit) return unique(op.explicit, keyOf);
  const sole = list.length === 0 ? soleList(op) : undefined;
  if (sole) return unique(sole, keyOf);
  const items = new Map(list.map((item) => [keyOf(item), item]));
  for (const item of op.deleted ?? []) items.delete(keyOf(item));
  for (const item of op.added ?? []) if (!items.has(keyOf(item))) items.set(keyOf(item), item);
  const front = unique(op.prepended ?? [], keyOf);
  for (const item of front) items.delete(keyOf(item));
  const back = unique(op.appended ?? [], keyOf);
  const moved = new Map([...front, ...items.values()].map((item) => [keyOf(item), item]));
  for (const item of back) moved.delete(keyOf(item));
  const all = [...moved.values(), ...back];
  return op.ordered ? inOrder(all, op.ordered.map(keyOf), keyOf) : all;
}

/** Fast path: a list op with one kind of edit, applied to an empty list. */
function soleList<T>({ added, prepended, appended, ordered }: ListOp<T>): readonly T[] | undefined {
  if (ordered) return undefined;
  if (!added && !appended) return prepended;
  if (!prepended && !appended) return added;
  return !prepended && !added ? appended : undefined;
}

function unique<T>(items: readonly T[], keyOf: (item: T) => string): T[] {
  if (items.length < 2) return [...items];
  const seen = new Map<string, T>();
  for (const item of items) if (!seen.has(keyOf(item))) seen.set(keyOf(item), item);
  return [...seen.values()];
}

/** Reorders items by `order`; each takes along the unnamed items after it. */
export function inOrder<T>(items: readonly T[], order: readonly string[], keyOf: (item: T) => string): T[] {
  const named = new Set(order);
  const runs = new Map<string, T[]>();
  const head: T[] = [];
  let run = head;
  for (const item of items) {
    const key = keyOf(item);
    if (named.has(key) && !runs.has(key)) {
      run = [];
      runs.set(key, run);
    }
    run.push(item);
  }
  return [...head, ...[...named].flatMap((key) => runs.get(key) ?? [])];
}

/** A list from its opinions, the strongest first. */
export function composeList<T>(ops: readonly ListOp<T>[], keyOf: (item: T) => string): T[] {
  const last = ops.findIndex((op) => op.explicit);
  const counted = last < 0 ? ops : ops.slice(0, last + 1);
  return counted.reduceRight<T[]>((list, op) => applyListOp(list, op, keyOf), []);
}
