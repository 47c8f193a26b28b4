import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { uiTexts } from '../i18n/texts.ts';

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

const [inFont = ''] = /(?<=FORMULAS = ").*(?=")/.exec(text('../../../scripts/pageFonts.py')) ?? [];
const inSheet = lettersOf(/inter-greek\.woff2[^}]*unicode-range:([^;]*)/.exec(text('fonts.css'))?.[1] ?? '');

it('the stylesheet declares exactly the Greek letters of the font subset', () => {
  expect(greek(inSheet)).toEqual(greek(inFont));
  expect(inFont).toContain('γ');
});

it('the page’s texts need no other Greek letters', () => {
  const used = greek(Object.values(uiTexts).flat().join(''));
  expect(used).toContain('γ');
  expect(used.filter((letter) => !inFont.includes(letter))).toEqual([]);
});
