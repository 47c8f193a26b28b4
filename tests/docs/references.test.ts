import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const CODE = ['src', 'tests', 'bench', 'scripts', 'examples'];

/** All files below a folder with one of the extensions, relative to the repository. */
const filesIn = (folder: string, extension: RegExp): string[] =>
  readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => join(folder, name))
    .filter((path) => extension.test(path) && !path.includes('node_modules'));

const read = (path: string): string => readFileSync(join(ROOT, path), 'utf8');
const codeFiles = CODE.flatMap((folder) => filesIn(folder, /\.(ts|tsx|mjs|py)$/));
const pages = [...filesIn('docs', /\.md$/), 'README.md', 'CONTRIBUTING.md'].filter((path) =>
  existsSync(join(ROOT, path)),
);

/** Section numbers of a page: 3 and 3.2 for `## 3. Light` and `### 3.2 Aberration`. */
const sectionsOf = (page: string): Set<string> =>
  new Set(Array.from(read(page).matchAll(/^#{2,} (\d+(?:\.\d+)*)\.? /gm), ([, number]) => number!));

const adrs = new Set(readdirSync(join(ROOT, 'docs/adr')).map((name) => Number.parseInt(name, 10)));

/** Each match of a pattern in the given files for which `holds` is false, with its file. */
function broken(files: readonly string[], pattern: RegExp, holds: (match: RegExpMatchArray, file: string) => boolean) {
  return files.flatMap((file) =>
    Array.from(read(file).matchAll(pattern))
      .filter((match) => !holds(match, file))
      .map(([text]) => `${relative('.', file)}: ${text}`),
  );
}

it('a cited section of a page exists', () => {
  const headingsOf = new Map<string, Set<string>>();
  const sections = (page: string): Set<string> => {
    const found = headingsOf.get(page) ?? (existsSync(join(ROOT, page)) ? sectionsOf(page) : new Set<string>());
    headingsOf.set(page, found);
    return found;
  };
  // Several sections may follow one page: `docs/physics.md §3.2, §3.3`.
  const citation = /(docs\/[\w./-]+\.md)((?:,? (?:and )?§\d+(?:\.\d+)*)+)/g;
  const holds = ([, page, list]: RegExpMatchArray): boolean =>
    Array.from(list!.matchAll(/\d+(?:\.\d+)*/g)).every(([number]) => sections(page!).has(number));
  expect(sectionsOf('docs/physics.md').size).toBeGreaterThan(50);
  expect(broken([...codeFiles, ...pages], citation, holds)).toEqual([]);
});

it('sections that docs/physics.md itself refers to exist', () => {
  const sections = sectionsOf('docs/physics.md');
  // Sections of books follow a name or a year, as in `Jackson §11.4` or `Einstein 1905, §8`.
  const own = /(?<!(?:Jackson|Rindler|MTW|R&L|HLW|HNW|Wolf) |\d{4}, |ed\., )§(\d+(?:\.\d+)*)/g;
  expect(Array.from(read('docs/physics.md').matchAll(own)).length).toBeGreaterThan(30);
  expect(broken(['docs/physics.md'], own, ([, number]) => sections.has(number!))).toEqual([]);
});

it('a cited decision exists', () => {
  expect(adrs.size).toBeGreaterThan(20);
  const holds = ([, number]: RegExpMatchArray): boolean => adrs.has(Number(number));
  expect(broken([...codeFiles, ...pages], /\bADR (\d+)/g, holds)).toEqual([]);
});

it('a file that a comment or a page names by its path exists', () => {
  const path = /(?<![\w/.-])((?:docs|src|tests|bench|scripts)\/[\w./-]+\.(?:md|ts|tsx|mjs|py))\b/g;
  const holds = ([, file]: RegExpMatchArray): boolean => existsSync(join(ROOT, file!));
  const here = 'tests/docs/references.test.ts';
  expect(
    broken([...codeFiles.filter((file) => file.startsWith('src') && file !== here), ...pages], path, holds),
  ).toEqual([]);
});

it('a folder of the program that a page names exists', () => {
  const path = /`(src\/[\w/-]+)`/g;
  expect(broken(pages, path, ([, folder]) => existsSync(join(ROOT, folder!)))).toEqual([]);
});

it('a file that a page names without its folder exists in some folder', () => {
  const names = new Set(codeFiles.map((file) => basename(file)));
  const name = /`([\w.-]+\.(?:ts|tsx|mjs|py))`/g;
  expect(broken(pages, name, ([, file]) => names.has(file!))).toEqual([]);
});

/** The anchors that GitHub gives the headings of a page. */
const anchorsOf = (page: string): string[] =>
  Array.from(read(page).matchAll(/^#+ (.*)$/gm), ([, title]) =>
    title!
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .replaceAll(' ', '-'),
  );

it('a link from page to page leads to a file, and to a heading of it', () => {
  const link = /\]\((?!https?:|mailto:)([^)#\s]*)(?:#([^)]*))?\)/g;
  const holds = ([, to, anchor]: RegExpMatchArray, page: string): boolean => {
    const target = to === '' ? page : join(dirname(page), to!);
    if (!existsSync(join(ROOT, target))) return false;
    return anchor === undefined || !target.endsWith('.md') || anchorsOf(target).includes(anchor);
  };
  expect(broken(pages, link, holds)).toEqual([]);
});
