/** Unique object paths from names, valid in USD. */
export class UniquePrimPaths {
  private readonly used = new Map<string, number>();
  /** `parent`: empty at the root. */
  of(parent: string, name: string): string {
    const clean = name.replace(/[^\p{L}\p{N}_]/gu, '_').replace(/^(?=\p{N})/u, '_') || '_';
    const wanted = `${parent}/${clean}`;
    let path = wanted;
    for (let i = this.used.get(wanted) ?? 0; this.used.has(path); ) path = `${wanted}_${++i}`;
    this.used.set(wanted, (this.used.get(wanted) ?? -1) + 1);
    if (path !== wanted) this.used.set(path, 0);
    return path;
  }
}
