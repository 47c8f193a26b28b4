import { readFileSync } from 'node:fs';
import { parseSync } from 'oxc-parser';
import { expect, it } from 'vitest';

const text = (path: string): string => readFileSync(new URL(path, import.meta.url), 'utf8');
const greek = (words: string): readonly string[] => [...new Set(words.match(/\p{Script=Greek}/gu))].toSorted();

/** The code points of a unicode-range such as `U+03B1-03B3, U+03C9`. */
function lettersOf(ranges: string): string {
  const bounds = ranges.split(',').map((range) => range.match(/[0-9A-F]+/g)!.map((code) => Number.parseInt(code, 16)));
  return bounds
    .flatMap(([first = 0, last = first]) => Array.from({ length: last - first + 1 }, (_, i) => first + i))
    .map((code) => String.fromCodePoint(code))
    .join('');
}

/** Sources of the program with all languages, and of the examples; shaders are not shown. */
const sources = import.meta.glob<string>(
  ['../../**/*.{ts,tsx}', '../../../examples/**/*.ts', '!../../{shaders,compute}/**', '!**/*.test.{ts,tsx}'],
  { query: '?raw', import: 'default', eager: true },
);

/** All strings and templates of a source that has Greek letters. */
function textsIn([file, source]: readonly [string, string]): string {
  if (greek(source).length === 0) return '';
  const texts: unknown[] = [];
  const walk = (node: unknown): void => {
    if (typeof node !== 'object' || node === null) return;
    const { type, value } = node as { readonly type?: string; readonly value?: unknown };
    if (type === 'Literal' || type === 'JSXText') texts.push(value);
    if (type === 'TemplateElement') texts.push((value as { readonly cooked: string }).cooked);
    Object.values(node).forEach(walk);
  };
  walk(parseSync(file, source).program);
  return texts.join('');
}

const [inFont = ''] = /(?<=FORMULAS = ").*(?=")/.exec(text('../../../scripts/pageFonts.py')) ?? [];
const inSheet = lettersOf(/inter-greek\.woff2[^}]*unicode-range:([^;]*)/.exec(text('fonts.css'))?.[1] ?? '');

it('the stylesheet declares exactly the Greek letters of the font subset', () => {
  expect(greek(inSheet)).toEqual(greek(inFont));
  expect(inFont).toContain('γ');
});

it('the texts of the program and of its examples need no other Greek letters', () => {
  const used = greek(Object.entries(sources).map(textsIn).join(''));
  expect(used).toContain('γ');
  expect(used.filter((letter) => !inFont.includes(letter))).toEqual([]);
});
