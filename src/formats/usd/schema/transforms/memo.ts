/** Memoizes by object keys; entries live as long as the first key. */
export class Memo<V> {
  private readonly roots = new WeakMap<object, MemoNode<V>>();

  getOrCreate(owner: object, keys: readonly unknown[], make: () => V): V {
    let branch = this.roots.get(owner) ?? new MemoNode<V>();
    this.roots.set(owner, branch);
    for (const key of keys) branch = branch.child(key);
    branch.entry ??= { value: make() };
    return branch.entry.value;
  }
}

class MemoNode<V> {
  entry: { readonly value: V } | undefined;
  private readonly next = new Map<unknown, MemoNode<V>>();

  child(key: unknown): MemoNode<V> {
    const branch = this.next.get(key) ?? new MemoNode<V>();
    this.next.set(key, branch);
    return branch;
  }
}
