import { type Message, msg } from '../../messages/message.ts';
import { inputError } from '../diagnostics/inputError.ts';

/** Scalar types by all their names, with their size [bytes]. */
const TYPES = new Map([
  ['char', 'int8'],
  ['uchar', 'uint8'],
  ['short', 'int16'],
  ['ushort', 'uint16'],
  ['int', 'int32'],
  ['uint', 'uint32'],
  ['float', 'float32'],
  ['double', 'float64'],
] as const);
export type ScalarType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';
export const SIZES: Readonly<Record<ScalarType, number>> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

/** A value of each row of an element; or, with `count`, a list of them whose length comes first. */
export interface Property {
  readonly name: string;
  readonly type: ScalarType;
  readonly count?: ScalarType;
}
export interface Element {
  readonly name: string;
  readonly rows: number;
  readonly properties: readonly Property[];
}
export interface PlyHeader {
  readonly format: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
  readonly elements: readonly Element[];
  /** Picture that a comment names, as MeshLab writes it. */
  readonly texture?: string;
  /** Where the rows begin [byte], and on which line. */
  readonly end: number;
  readonly endLine: number;
}

/** Maximum header length [bytes], number of elements, and properties per element. */
const MAX_HEADER = 2 ** 18;
export const MAX_PROPERTIES = 1000;

/** Throws an InputError that names the line of an invalid header. */
export function readHeader(bytes: Uint8Array, entry: string): PlyHeader {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, MAX_HEADER));
  const fail = (line: number, message: Message): Error =>
    inputError('ply.header', msg`${entry}: line ${line}`, message);
  const end = /^[ \t]*end_header[ \t]*(\r\n|\n|\r)/m.exec(text);
  if (!/^ply\s*$/m.test(text.slice(0, 5))) throw fail(1, msg`it does not begin with ply; it is no PLY`);
  if (!end) throw fail(1, msg`its header has no end_header; the file is cut off or damaged, copy it again`);
  const builder = new HeaderBuilder(fail);
  const lines = text.slice(0, end.index).split(/\r\n|\n|\r/);
  for (const [i, line] of lines.entries()) if (i > 0) builder.read(i + 1, line.trim());
  return { ...builder.finish(), end: end.index + end[0].length, endLine: lines.length };
}

class HeaderBuilder {
  private readonly fail: (line: number, message: Message) => Error;
  private readonly elements: { name: string; rows: number; properties: Property[] }[] = [];
  private format: PlyHeader['format'] | undefined;
  private texture: string | undefined;
  constructor(fail: (line: number, message: Message) => Error) {
    this.fail = fail;
  }

  read(line: number, text: string): void {
    const words = text.split(/\s+/);
    if (words[0] === 'format') this.readFormat(line, words);
    else if (words[0] === 'element') this.readElement(line, words);
    else if (words[0] === 'property') this.readProperty(line, words);
    else if (words[0] === 'comment') this.texture ??= /^comment\s+TextureFile\s+(.+)$/i.exec(text)?.[1];
    else if (words[0] !== 'obj_info' && text !== '')
      throw this.fail(line, msg`${words[0].slice(0, 40)} is not known in a header`);
  }

  finish(): Omit<PlyHeader, 'end' | 'endLine'> {
    if (!this.format) throw this.fail(2, msg`its header has no format`);
    return {
      format: this.format,
      elements: this.elements,
      ...(this.texture !== undefined && { texture: this.texture }),
    };
  }

  private readFormat(line: number, [, format = '', version = '']: readonly string[]): void {
    const isKnown = format === 'ascii' || format === 'binary_little_endian' || format === 'binary_big_endian';
    if (!isKnown || version !== '1.0') throw this.fail(line, msg`the format ${format} ${version} is not known`);
    this.format = format;
  }

  private readElement(line: number, [, name = '', count = '']: readonly string[]): void {
    const rows = /^\d{1,15}$/.test(count) ? Number(count) : Number.NaN;
    if (!name || Number.isNaN(rows))
      throw this.fail(line, msg`an element needs a name and a count, not ${name} ${count}`);
    if (this.elements.some((element) => element.name === name))
      throw this.fail(line, msg`the element ${name} comes twice`);
    if (this.elements.length >= MAX_PROPERTIES)
      throw this.fail(line, msg`there are more than ${MAX_PROPERTIES} elements`);
    this.elements.push({ name, rows, properties: [] });
  }

  private readProperty(line: number, words: readonly string[]): void {
    const properties = this.elements.at(-1)?.properties;
    if (!properties) throw this.fail(line, msg`a property comes before the first element`);
    if (properties.length >= MAX_PROPERTIES)
      throw this.fail(line, msg`an element has more than ${MAX_PROPERTIES} properties`);
    const isList = words[1] === 'list';
    const name = words[isList ? 4 : 2];
    const type = this.type(line, words[isList ? 3 : 1]);
    if (!name) throw this.fail(line, msg`a property has no name`);
    properties.push(isList ? { name, type, count: this.type(line, words[2]) } : { name, type });
  }

  private type(line: number, name = ''): ScalarType {
    const type = TYPES.get(name as 'int') ?? name;
    if (Object.hasOwn(SIZES, type)) return type as ScalarType;
    throw this.fail(line, msg`the type ${name} is not known`);
  }
}
