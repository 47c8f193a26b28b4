import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync } from 'oxc-parser';
import { describe, expect, it } from 'vitest';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const MAX_FILES = 22;
/** Folders of data, whose number of files is not limited. */
const DATA = /\/(?:fixtures|testdata|fonts)(?:\/|$)/;
/** Names of both a 64-bit type and its counterpart on the GPU: `Vec3` of math and of TSL. */
const TWINS = ['Vec3'];

const entries = readdirSync(join(ROOT, 'src'), { recursive: true, withFileTypes: true }).map((entry) => ({
  name: entry.name,
  isFolder: entry.isDirectory(),
  path: join(entry.parentPath, entry.name).slice(ROOT.length).replace(/^\//, ''),
  folder: entry.parentPath.slice(ROOT.length).replace(/^\//, ''),
}));
const sources = entries.filter(
  ({ path }) => /\.tsx?$/.test(path) && !/\.test\.|\.d\.ts$/.test(path) && !DATA.test(path),
);

/** Names of the types declared in a file, exported or not. */
function typesIn(path: string): string[] {
  const { program } = parseSync(path, readFileSync(join(ROOT, path), 'utf8'));
  return program.body.flatMap((statement) => {
    const declared = statement.type === 'ExportNamedDeclaration' ? statement.declaration : statement;
    const isType =
      declared?.type === 'TSInterfaceDeclaration' ||
      declared?.type === 'TSTypeAliasDeclaration' ||
      declared?.type === 'ClassDeclaration';
    return isType && declared.id ? [declared.id.name] : [];
  });
}

describe('the code base', () => {
  const declarations = new Map<string, string[]>();
  for (const { path } of sources)
    for (const name of typesIn(path)) declarations.set(name, [...(declarations.get(name) ?? []), path]);

  it('declares each type name once', () => {
    expect(declarations.size).toBeGreaterThan(1000);
    const twice = [...declarations].filter(([name, files]) => files.length > 1 && !TWINS.includes(name));
    expect(twice).toEqual([]);
  });

  it('has folders of limited size, each with a README', () => {
    const folders = entries.filter(({ isFolder, path }) => isFolder && !DATA.test(path));
    expect(folders.length).toBeGreaterThan(100);
    const filesOf = (folder: string) => entries.filter((entry) => !entry.isFolder && entry.folder === folder);
    const crowded = folders.filter(({ path }) => filesOf(path).length > MAX_FILES).map(({ path }) => path);
    const unnamed = folders.filter(({ path }) => !existsSync(join(ROOT, path, 'README.md'))).map(({ path }) => path);
    expect({ crowded, unnamed }).toEqual({ crowded: [], unnamed: [] });
  });

  it('has each term of its glossary once, declared at the stated place', () => {
    const rows = readFileSync(join(ROOT, 'docs/glossary.md'), 'utf8')
      .split('\n')
      .filter((line) => /^\| (?!term |-)/.test(line) && !line.startsWith('|---'))
      .map((line) => line.split(/(?<!\\)\|/).map((cell) => cell.trim()));
    expect(rows.length).toBeGreaterThan(300);
    const terms = rows.map(([, term]) => term!);
    expect(terms.filter((term, i) => terms.indexOf(term) !== i)).toEqual([]);
    const lost = rows.flatMap(([, term, , , , place]) => {
      const name = /^`(\w+)`$/.exec(term!)?.[1];
      const at = join(ROOT, place!);
      if (!existsSync(at)) return [`${term}: ${place} is not there`];
      const isIn = (file: string) => new RegExp(`\\b${name}\\b`).test(readFileSync(file, 'utf8'));
      const files = basename(place!).includes('.') ? [at] : readdirSync(at).map((file) => join(at, file));
      return name && !files.some((file) => basename(file).includes('.') && isIn(file))
        ? [`${term}: not in ${place}`]
        : [];
    });
    expect(lost).toEqual([]);
  });
});
