/**
 * The file that a reference most likely means which leads to none: of the same name, with as many of the folders before it
 * in common as any other, where that is only one (`../textures/a.png` in a flat selection → `a.png`). Case counts only where
 * names differ by nothing else.
 */
export function nearestPath(paths: Iterable<string>, wanted: string): string | undefined {
  const all = [...paths];
  return nearest(all, wanted, (part) => part) ?? nearest(all, wanted, (part) => part.toLowerCase());
}

function nearest(paths: readonly string[], wanted: string, as: (part: string) => string): string | undefined {
  const parts = as(wanted).split('/').reverse();
  let [best, most, isOnly] = ['', 0, false];
  for (const path of paths) {
    const other = as(path).split('/').reverse();
    let common = 0;
    while (common < parts.length && common < other.length && other[common] === parts[common]) common++;
    if (common > most) [best, most, isOnly] = [path, common, true];
    else if (common === most) isOnly = false;
  }
  return most > 0 && isOnly ? best : undefined;
}
