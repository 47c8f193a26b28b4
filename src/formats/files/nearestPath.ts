/**
 * The most likely file for a broken reference: of the same name, with the most leading folders in common, if unique
 * (`../textures/a.png` in a flat selection → `a.png`). Case is ignored unless it alone tells names apart.
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
