/** Unused keys derived from a wanted one: `blur`, `blur2`, `blur3`. */
export class FreshKeys {
  private readonly taken: Set<string>;
  /** Next number to try for each word. */
  private readonly nextNumber = new Map<string, number>();

  constructor(...tables: readonly object[]) {
    this.taken = new Set(tables.flatMap((table) => Object.keys(table)));
  }

  next(wanted: string): string {
    const key = this.taken.has(wanted) ? this.numbered(wanted) : wanted;
    this.taken.add(key);
    return key;
  }

  private numbered(wanted: string): string {
    // Keys have at most 64 characters.
    const word = wanted.replace(/\d+$/, '').slice(0, 56) || 'node';
    let number = this.nextNumber.get(word) ?? 2;
    while (this.taken.has(`${word}${number}`)) number++;
    this.nextNumber.set(word, number + 1);
    return `${word}${number}`;
  }
}
