/** Memoizes by object keys; entries live as long as the first key. */
export class Memo<V> {
  private readonly known = new WeakMap<object, MemoNode<V>>();

  getOrCreate(owner: object, things: readonly unknown[], make: () => V): V {
    let branch = this.known.get(owner) ?? new MemoNode<V>();
    this.known.set(owner, branch);
    for (const thing of things) branch = branch.child(thing);
    branch.entry ??= { value: make() };
    return branch.entry.value;
  }
}

class MemoNode<V> {
  entry: { readonly value: V } | undefined;
  private readonly next = new Map<unknown, MemoNode<V>>();

  child(thing: unknown): MemoNode<V> {
    const branch = this.next.get(thing) ?? new MemoNode<V>();
    this.next.set(thing, branch);
    return branch;
  }
}
