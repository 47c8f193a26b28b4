/** A row of the table of folders in docs/adr/0001-folders.md. */
export interface FolderRow {
  readonly folder: string;
  /** `math, physics`, `all above`, `all above but graph` or `nothing`. */
  readonly imports: string;
}

/** Cells of the rows of the table with this head. */
function rowsOf(page: string, head: string): string[][] {
  const [, rows] = page.split(`${head}\n`)[1]!.split(/^\|[-|]+\|\n/m) as [string, string];
  return rows
    .slice(0, rows.search(/^(?!\|)/m))
    .trim()
    .split('\n')
    .map((row) => row.split('|').map((cell) => cell.trim()));
}

export const folderRows = (adr: string): readonly FolderRow[] =>
  rowsOf(adr, '| folder | contents | may import |').map(([, folder, , imports]) => ({
    folder: folder!.replaceAll(/[`/]/g, ''),
    imports: imports!,
  }));

/** The folders that a row allows, in the order of the table. */
function allowedFolders({ folder, imports }: FolderRow, rows: readonly FolderRow[]): readonly string[] {
  if (imports === 'nothing') return [];
  const names = rows.map((row) => row.folder);
  const listed = imports.replace(/^all above(?: but )?/, '').split(', ');
  const unknown = listed.filter((name) => name !== '' && !names.includes(name));
  if (unknown.length > 0) throw new Error(`${folder}/: there is no folder ${unknown.join(', ')}`);
  if (!imports.startsWith('all above')) return listed;
  return names.slice(0, names.indexOf(folder)).filter((name) => !listed.includes(name));
}

/** Import patterns of a package. */
function packagePatterns(name: string): readonly string[] {
  if (name === 'node:') return ['node:*'];
  return name.startsWith('@') ? [`${name}/**`] : [name, `${name}/**`];
}

/** Biome's configuration that enforces the tables of docs/adr/0001-folders.md; tests may import everything. */
export function importRules(adr: string): object {
  const rows = folderRows(adr);
  const packages = rowsOf(adr, '| packages | only in |').map(
    ([, names, places]) => ({ names: names!.split(', '), places: places!.split(', ') }) as const,
  );
  const why = '(docs/adr/0001-folders.md).';
  const overrides = rows.map((row) => {
    const { folder } = row;
    const allowed = allowedFolders(row, rows);
    const others = rows.map((other) => other.folder).filter((name) => name !== folder && !allowed.includes(name));
    const foreign = packages.flatMap(({ names, places }) => (places.includes(folder) ? [] : names));
    const patterns = [
      {
        group: others.flatMap((name) => [`../**/${name}/**`, `../${name}/**`]),
        message: `${folder}/ may import only: ${allowed.join(', ') || 'nothing'} ${why}`,
      },
      { group: foreign.flatMap(packagePatterns), message: `${folder}/ does not know this package ${why}` },
    ];
    const options = { patterns: patterns.filter(({ group }) => group.length > 0) };
    const rule = { noRestrictedImports: { level: 'error', options } };
    return {
      includes: [`src/${folder}/**`, '!**/*.test.ts', '!**/*.test.tsx'],
      linter: { rules: { style: rule } },
    };
  });
  return { $schema: './node_modules/@biomejs/biome/configuration_schema.json', overrides };
}
