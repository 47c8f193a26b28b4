/** What is made of some things, made once for the same ones, as long as the first of them is there. */
export class Once<V> {
  private readonly known = new WeakMap<object, Branch<V>>();

  of(owner: object, things: readonly unknown[], make: () => V): V {
    let branch = this.known.get(owner) ?? new Branch<V>();
    this.known.set(owner, branch);
    for (const thing of things) branch = branch.to(thing);
    branch.made ??= { value: make() };
    return branch.made.value;
  }
}

class Branch<V> {
  made: { readonly value: V } | undefined;
  private readonly next = new Map<unknown, Branch<V>>();

  to(thing: unknown): Branch<V> {
    const branch = this.next.get(thing) ?? new Branch<V>();
    this.next.set(thing, branch);
    return branch;
  }
}
