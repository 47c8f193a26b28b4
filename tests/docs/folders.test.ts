import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

const ROOT = new URL('../../', import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, ROOT), 'utf8');

interface ImportRule {
  readonly includes: readonly [files: string, ...others: string[]];
  readonly linter: {
    readonly rules: {
      readonly style: {
        readonly noRestrictedImports: {
          readonly options: { readonly patterns: readonly { readonly group: string[] }[] };
        };
      };
    };
  };
}
const { overrides } = JSON.parse(read('biome.json')) as { readonly overrides: readonly ImportRule[] };
/** The patterns that each folder may not import. */
const forbidden = new Map(
  overrides.map(({ includes, linter }) => [
    /^src\/(\w+)\/\*\*$/.exec(includes[0])![1]!,
    linter.rules.style.noRestrictedImports.options.patterns.flatMap(({ group }) => group),
  ]),
);

/** Rows of the table with this head, cell by cell. */
function rowsOf(page: string, head: string): string[][] {
  const [, rows] = page.split(`${head}\n`)[1]!.split(/^\|[-|]+\|\n/m) as [string, string];
  return rows
    .slice(0, rows.search(/^(?!\|)/m))
    .trim()
    .split('\n')
    .map((row) => row.split('|').map((cell) => cell.trim()));
}

const adr = read('docs/adr/0001-folders.md');
const folderRows = rowsOf(adr, '| folder | contents | may import |').map(
  ([, folder, , imports]) => [folder!.replaceAll(/[`/]/g, ''), imports!] as const,
);
const folders = folderRows.map(([folder]) => folder);
const packageRows = rowsOf(adr, '| packages | only in |').map(
  ([, packages, places]) => [packages!.split(', '), places!.split(', ')] as const,
);

/** `math, physics`, `all above but graph` or `nothing`. */
function allowedFolders(text: string, above: readonly string[]): readonly string[] {
  if (text === 'nothing') return [];
  const [, excepted] = /^all above(?: but (.*))?$/.exec(text) ?? [];
  if (!text.startsWith('all above')) return text.split(', ');
  return above.filter((folder) => !excepted?.split(', ').includes(folder));
}

const patternsOf = (name: string): string[] => {
  if (name === 'node:') return ['node:*'];
  if (name.startsWith('@')) return [`${name}/**`];
  return ['three', 'react', 'react-dom'].includes(name) ? [name, `${name}/**`] : [name];
};

describe('the import rules of biome.json', () => {
  it('are for the folders of docs/adr/0001-folders.md, which has all of src/', () => {
    const here = readdirSync(new URL('src/', ROOT), { withFileTypes: true }).filter((entry) => entry.isDirectory());
    expect(here.map(({ name }) => name).filter((name) => !folders.includes(name))).toEqual([]);
    expect([...forbidden.keys()].sort()).toEqual([...folders].sort());
  });

  it.each(folderRows)('%s/ may import: %s', (folder, text) => {
    const allowed = allowedFolders(text, folders.slice(0, folders.indexOf(folder)));
    expect(allowed.filter((each) => !folders.includes(each))).toEqual([]);
    const others = folders.filter((each) => each !== folder && !allowed.includes(each));
    const packages = packageRows.flatMap(([names, places]) => (places.includes(folder) ? [] : names));
    expect([...(forbidden.get(folder) ?? [])].sort()).toEqual(
      [...others.flatMap((each) => [`../**/${each}/**`, `../${each}/**`]), ...packages.flatMap(patternsOf)].sort(),
    );
  });
});
