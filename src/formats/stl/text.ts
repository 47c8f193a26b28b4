import type { Vec3 } from '../../math/vec3.ts';
import { anyOf, type Message, msg } from '../../messages/message.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { type GrowableFloats, growableFloats } from '../files/growableArray.ts';
import { parseFiniteNumber, textLines } from '../files/textLines.ts';
import { type Facets, facetNormal, isTurned } from './facets.ts';

/** The solids of a text: `solid`, `facet normal`, `outer loop`, three `vertex`, `endloop`, `endfacet`, `endsolid`. */
export function readStlText(bytes: Uint8Array, entry: string): Facets[] {
  const reader = new StlTextReader(entry);
  for (const { number, text } of textLines(bytes, entry)) reader.read(number, text.trim());
  return reader.finish();
}

interface Solid {
  readonly name: string;
  readonly points: GrowableFloats;
  turned: number;
}

/** Keywords that may follow each keyword. */
const EXPECTED: ReadonlyMap<string, readonly string[]> = new Map([
  ['file', ['solid']],
  ['solid', ['facet', 'endsolid']],
  ['facet', ['outer', 'endfacet']],
  ['loop', ['vertex', 'endloop']],
]);
/** Maximum number of solids of one file; each becomes an object. */
export const MAX_SOLIDS = 2 ** 16;

class StlTextReader {
  private readonly entry: string;
  private readonly solids: Solid[] = [];
  private inside: 'file' | 'solid' | 'facet' | 'loop' = 'file';
  private normal: Vec3 = [0, 0, 0];
  private corners: Vec3[] = [];
  private line = 0;
  constructor(entry: string) {
    this.entry = entry;
  }

  read(line: number, text: string): void {
    if (text === '') return;
    this.line = line;
    const words = text.split(/\s+/);
    const keyword = words[0].toLowerCase();
    const expected = EXPECTED.get(this.inside)!;
    if (!expected.includes(keyword)) {
      throw this.error(
        'stl.syntax',
        msg`${anyOf(expected)} should stand here, not ${words[0].slice(0, 40)}; export it again`,
      );
    }
    if (keyword === 'solid') this.open(text.slice(5).trim());
    else if (keyword === 'facet') this.openFacet(words);
    else if (keyword === 'outer') this.inside = 'loop';
    else if (keyword === 'vertex') this.addCorner(words);
    else if (keyword === 'endloop') this.closeLoop();
    else this.inside = keyword === 'endfacet' ? 'solid' : 'file';
  }

  finish(): Facets[] {
    if (this.inside !== 'file')
      throw this.error('stl.truncated', msg`the file ends inside a ${this.inside}; it is cut off, copy it again`);
    return this.solids.map(({ name, points, turned }) => ({ name, points: points.values().slice(), turned }));
  }

  private open(name: string): void {
    if (this.solids.length >= MAX_SOLIDS)
      throw this.error('stl.too-many', msg`there are more than ${MAX_SOLIDS} solids; join some`);
    this.solids.push({ name, points: growableFloats(), turned: 0 });
    this.inside = 'solid';
  }

  private openFacet(words: readonly string[]): void {
    // Invalid normals are ignored: the winding gives them.
    const [x, y, z] = words.slice(2).map(Number);
    this.normal = [x, y, z];
    this.corners = [];
    this.inside = 'facet';
  }

  private addCorner(words: readonly string[]): void {
    if (this.corners.length === 3)
      throw this.error('stl.corners', msg`a facet has 3 corners, this one more; export it again`);
    this.corners.push(this.vector(words));
  }

  private closeLoop(): void {
    const solid = this.solids.at(-1)!;
    const corners = this.corners;
    if (corners.length !== 3)
      throw this.error('stl.corners', msg`a facet has 3 corners, this one ${corners.length}; export it again`);
    for (const [x, y, z] of corners) solid.points.push(x, y, z);
    if (isTurned(this.normal, facetNormal(corners.flat(), 0))) solid.turned++;
    this.corners = [];
    this.inside = 'facet';
  }

  private vector(words: readonly string[]): Vec3 {
    const number = (k: number): number =>
      parseFiniteNumber(words[1 + k], (message) => this.error('stl.number', message));
    return [number(0), number(1), number(2)];
  }

  private error(code: DiagnosticCode, message: Message): Error {
    return inputError(code, msg`${this.entry}: line ${this.line}`, message);
  }
}
