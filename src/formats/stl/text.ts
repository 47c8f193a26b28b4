import type { Vec3 } from '../../math/vec3.ts';
import type { Code } from '../codes.ts';
import { inputError } from '../fail.ts';
import { type Floats, growingFloats } from '../growing.ts';
import { numberIn, textLines } from '../textLines.ts';
import { type Facets, facetNormal, isTurned } from './facets.ts';

/** The solids of a text: `solid`, `facet normal`, `outer loop`, three `vertex`, `endloop`, `endfacet`, `endsolid`. */
export function readText(bytes: Uint8Array, entry: string): Facets[] {
  const reader = new TextReader(entry);
  for (const { number, text } of textLines(bytes, entry)) reader.read(number, text.trim());
  return reader.finish();
}

interface Solid {
  readonly name: string;
  readonly points: Floats;
  turned: number;
}

/** What may stand next; each word opens or closes something. */
const EXPECTED: ReadonlyMap<string, readonly string[]> = new Map([
  ['file', ['solid']],
  ['solid', ['facet', 'endsolid']],
  ['facet', ['outer', 'endfacet']],
  ['loop', ['vertex', 'endloop']],
]);
/** Most solids of one file: each becomes an object. */
export const MAX_SOLIDS = 2 ** 16;

class TextReader {
  readonly #entry: string;
  readonly #solids: Solid[] = [];
  #inside: 'file' | 'solid' | 'facet' | 'loop' = 'file';
  #normal: Vec3 = [0, 0, 0];
  #corners: Vec3[] = [];
  #line = 0;
  constructor(entry: string) {
    this.#entry = entry;
  }

  read(line: number, text: string): void {
    if (text === '') return;
    this.#line = line;
    const words = text.split(/\s+/);
    const keyword = words[0].toLowerCase();
    const expected = EXPECTED.get(this.#inside)!;
    if (!expected.includes(keyword)) {
      throw this.#error(
        'stl.syntax',
        `${expected.join(' or ')} should stand here, not ${words[0].slice(0, 40)}; export it again`,
      );
    }
    if (keyword === 'solid') this.#open(text.slice(5).trim());
    else if (keyword === 'facet') this.#openFacet(words);
    else if (keyword === 'outer') this.#inside = 'loop';
    else if (keyword === 'vertex') this.#addCorner(words);
    else if (keyword === 'endloop') this.#closeLoop();
    else this.#inside = keyword === 'endfacet' ? 'solid' : 'file';
  }

  finish(): Facets[] {
    if (this.#inside !== 'file')
      throw this.#error('stl.truncated', `the file ends inside a ${this.#inside}; it is cut off, copy it again`);
    return this.#solids.map(({ name, points, turned }) => ({ name, points: points.values().slice(), turned }));
  }

  #open(name: string): void {
    if (this.#solids.length >= MAX_SOLIDS)
      throw this.#error('stl.too-many', `there are more than ${MAX_SOLIDS} solids; join some`);
    this.#solids.push({ name, points: growingFloats(), turned: 0 });
    this.#inside = 'solid';
  }

  #openFacet(words: readonly string[]): void {
    // A normal that is not a number is of no consequence: the corners tell it.
    const [x, y, z] = words.slice(2).map(Number);
    this.#normal = [x, y, z];
    this.#corners = [];
    this.#inside = 'facet';
  }

  #addCorner(words: readonly string[]): void {
    if (this.#corners.length === 3)
      throw this.#error('stl.corners', 'a facet has 3 corners, this one more; export it again');
    this.#corners.push(this.#vector(words));
  }

  #closeLoop(): void {
    const solid = this.#solids.at(-1)!;
    const corners = this.#corners;
    if (corners.length !== 3)
      throw this.#error('stl.corners', `a facet has 3 corners, this one ${corners.length}; export it again`);
    for (const [x, y, z] of corners) solid.points.push(x, y, z);
    if (isTurned(this.#normal, facetNormal(corners.flat(), 0))) solid.turned++;
    this.#corners = [];
    this.#inside = 'facet';
  }

  #vector(words: readonly string[]): Vec3 {
    const number = (k: number): number => numberIn(words[1 + k], (message) => this.#error('stl.number', message));
    return [number(0), number(1), number(2)];
  }

  #error(code: Code, message: string): Error {
    return inputError(code, `${this.#entry}: line ${this.#line}`, message);
  }
}
