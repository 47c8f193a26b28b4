import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { simulateCommand } from '../../src/cli/simulate/simulateCommand.ts';
import { sceneFormats } from '../../src/formats/registry.ts';
import { writtenExtensions } from '../../src/formats/save.ts';

const ROOT = new URL('../../', import.meta.url);
const read = (path: string): string => readFileSync(fileURLToPath(new URL(path, ROOT)), 'utf8');
const guide = readdirSync(new URL('docs/guide/', ROOT)).filter((file) => file.endsWith('.md'));
/** Without the page of formats, which is generated and has rows about some of them. */
const pages = ['README.md', ...guide.filter((file) => file !== 'formats.md').map((file) => `docs/guide/${file}`)];

const names = sceneFormats.map(({ shortName }) => shortName);
/** Those without structure: one extension, one page of the guide. */
const meshes = sceneFormats.filter(({ extensions }) => extensions.length === 1).map(({ shortName }) => shortName);

it('a list of formats in a page names all that are read, or all formats of meshes', () => {
  const one = `(?:${names.join('|')})(?: \\([^)]*\\))?`;
  const lists = pages.flatMap((page) =>
    Array.from(read(page).matchAll(new RegExp(`${one}(?:(?:, | or | and )${one}){2,}`, 'g')), ([list]) => ({
      page,
      list,
      named: Array.from(list.replaceAll(/\([^)]*\)/g, '').matchAll(/\w+/g), String).filter((w) => names.includes(w)),
    })),
  );
  expect(lists.length).toBeGreaterThanOrEqual(4);
  const odd = lists.filter(({ named }) => `${named}` !== `${names}` && `${named}` !== `${meshes}`);
  expect(odd).toEqual([]);
});

it('extensions in brackets behind the name of a format are all that it has', () => {
  const bracketed = new RegExp(`(${names.join('|')}) \\((\`\\.\\w+\`(?:, \`\\.\\w+\`)*)\\)`, 'g');
  const found = pages.flatMap((page) =>
    Array.from(read(page).matchAll(bracketed), ([, name, list]) => [name, list!.match(/\w+/g)] as const),
  );
  expect(found.length).toBeGreaterThan(1);
  for (const [name, extensions] of found)
    expect(extensions).toEqual(sceneFormats.find(({ shortName }) => shortName === name)?.extensions);
});

it('what convert writes is what the command line’s page says', () => {
  const [, rows] = /\| file \| holds \|\n\|.*\n((?:\|.*\n)+)/.exec(read('docs/guide/command-line.md'))!;
  const cells = Array.from(rows!.matchAll(/^\| ([^|]*) \|/gm), ([, cell]) => cell!).join();
  expect(cells.match(/\w+/g)!.sort()).toEqual([...writtenExtensions].sort());
});

it('the examples of extensions in the help of simulate can be written', () => {
  const help = simulateCommand().options.find(({ long }) => long === '--output')!.description;
  const named = Array.from(help.matchAll(/\.(\w+)/g), ([, extension]) => extension!);
  expect(named.length).toBeGreaterThan(2);
  expect(named.filter((extension) => !writtenExtensions.includes(extension))).toEqual([]);
});

it('the comparison of outputs knows every format', () => {
  const jobs = read('scripts/sameOutputs/jobs.mjs');
  const opened = /SCENE_FILE = \/\\\.\(([\w|]+)\)\$\//.exec(jobs)![1]!.split('|');
  expect(opened.sort()).toEqual(sceneFormats.flatMap(({ extensions }) => extensions).sort());
  const written = /FORMATS = \[([^\]]*)\]/.exec(jobs)![1]!.match(/\w+/g);
  expect(written).toEqual(writtenExtensions);
});
