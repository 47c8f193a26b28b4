/** `/A/B/C` → `/A/B`, `/A` */
export function ancestors(path: string): string[] {
  const end = path.lastIndexOf('/');
  return end > 0 ? [path.slice(0, end), ...ancestors(path.slice(0, end))] : [];
}

/** The longest path that all are below; empty if there is none. */
export function commonAncestor(paths: readonly string[]): string {
  const [first = '', ...others] = paths;
  return ancestors(first).find((path) => others.every((other) => other.startsWith(`${path}/`))) ?? '';
}
