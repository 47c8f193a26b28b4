import { type LocalizedText, msg } from '../../../../messages/message.ts';
import type { SectionName } from './bootstrap.ts';
import { type CrateSource, Cursor } from './crateSource.ts';
import { readInt32s } from './integerCompression.ts';
import { decompress, MAX_EXPANSION } from './lz4.ts';
import { type PathNode, readPaths } from './pathTree.ts';

/** Structural sections of a crate: tokens, field sets, specs. */
export interface Structure {
  readonly tokens: readonly string[];
  /** Index of a string → index of its token. */
  readonly strings: Uint32Array;
  readonly fields: FieldTable;
  /** Indices of fields; −1 ends a set. */
  readonly fieldSets: Int32Array;
  readonly paths: readonly (PathNode | undefined)[];
  readonly specs: SpecTable;
}

export interface FieldTable {
  /** Token of each field's name. */
  readonly names: Int32Array;
  /** Value representations: pairs of 32 bits, the low ones first. */
  readonly values: Uint32Array;
}

export interface SpecTable {
  readonly paths: Int32Array;
  /** Where each spec's set begins in the field sets. */
  readonly fieldSets: Int32Array;
  readonly types: Int32Array;
}

const A_STRING = msg`a string`;

/** Memory of a string besides its characters [bytes]. */
const TEXT_BYTES = 32;

export function readStructure(source: CrateSource, sections: ReadonlyMap<SectionName, number>): Structure {
  const enter = (name: SectionName): Cursor => {
    source.section = name;
    return new Cursor(source, sections.get(name)!);
  };
  const tokens = readTokens(enter('TOKENS'));
  return {
    tokens,
    strings: readStrings(enter('STRINGS'), tokens.length),
    fields: readFields(enter('FIELDS'), tokens.length),
    fieldSets: readFieldSets(enter('FIELDSETS')),
    paths: readPaths(enter('PATHS'), tokens),
    specs: readSpecs(enter('SPECS')),
  };
}

/** Null-terminated strings, compressed. */
function readTokens(cursor: Cursor): string[] {
  const { source, at } = cursor;
  const count = cursor.i64(msg`the number of tokens`);
  const size = cursor.i64(msg`the size of the tokens`);
  const length = cursor.count(msg`bytes of compressed tokens`, 1);
  const from = cursor.pass(length, msg`the tokens`);
  if (size < 0 || size > MAX_EXPANSION * length)
    source.fail(msg`it says ${size} bytes of tokens, which ${length} compressed bytes cannot hold`, at);
  if (count < 0 || count > size) source.fail(msg`it says ${count} tokens in ${size} bytes`, at);
  source.spend(2 * size + TEXT_BYTES * count, msg`${count} tokens`, at);
  const out = new Uint8Array(size);
  return splitTokens(source, out.subarray(0, decompress(source, from, length, out)), count, at);
}

function splitTokens(source: CrateSource, bytes: Uint8Array, count: number, at: number): string[] {
  const tokens: string[] = [];
  for (let start = 0; tokens.length < count; ) {
    const end = bytes.indexOf(0, start);
    if (end < 0) source.fail(msg`of ${count} tokens there are ${tokens.length}`, at);
    tokens.push(textOf(bytes, start, end) ?? source.fail(msg`token ${tokens.length} is not UTF-8`, at));
    start = end + 1;
  }
  return tokens;
}

const utf8 = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
/** Up to this length ASCII is decoded faster without TextDecoder. */
const MAX_ASCII_LENGTH = 24;

/** Undefined for what is not UTF-8. */
function textOf(bytes: Uint8Array, start: number, end: number): string | undefined {
  let text = '';
  for (let i = start; i < end; i++) {
    if (i - start > MAX_ASCII_LENGTH || bytes[i] > 127) return decode(bytes.subarray(start, end));
    text += String.fromCharCode(bytes[i]);
  }
  return text;
}

function decode(bytes: Uint8Array): string | undefined {
  try {
    return utf8.decode(bytes);
  } catch {
    return undefined;
  }
}

function readStrings(cursor: Cursor, tokens: number): Uint32Array {
  const { source, at } = cursor;
  const count = cursor.count(msg`strings`, 4);
  source.spend(4 * count, msg`${count} strings`, at);
  return Uint32Array.from({ length: count }, (_, i) => {
    const token = cursor.u32(A_STRING);
    return token < tokens ? token : source.fail(msg`string ${i} is token ${token} of ${tokens}`, cursor.at - 4);
  });
}

/** Item count of a section; memory is checked when they are decompressed. */
function readCount(cursor: Cursor, what: LocalizedText): number {
  const { at } = cursor;
  const count = cursor.i64(msg`the number of ${what}`);
  return count >= 0 && count < 2 ** 31 ? count : cursor.source.fail(msg`it says ${count} ${what}`, at);
}

function readFields(cursor: Cursor, tokens: number): FieldTable {
  const { source, at } = cursor;
  const count = readCount(cursor, msg`fields`);
  const names = readInt32s(cursor, count, msg`names of fields`);
  const wrong = names.findIndex((name) => name < 0 || name >= tokens);
  if (wrong >= 0) source.fail(msg`the name of field ${wrong} is token ${names[wrong]} of ${tokens}`, at);
  const length = cursor.count(msg`bytes of compressed values`, 1);
  const from = cursor.pass(length, msg`the values of fields`);
  source.spend(8 * count, msg`the values of ${count} fields`, at);
  const values = new Uint32Array(2 * count);
  const size = decompress(source, from, length, new Uint8Array(values.buffer));
  if (size < 8 * count) source.fail(msg`the values of ${count} fields take ${size} bytes, not ${8 * count}`, from);
  return { names, values };
}

function readFieldSets(cursor: Cursor): Int32Array {
  return readInt32s(cursor, readCount(cursor, msg`fields of sets`), msg`fields of sets`);
}

function readSpecs(cursor: Cursor): SpecTable {
  const count = readCount(cursor, msg`specs`);
  return {
    paths: readInt32s(cursor, count, msg`paths of specs`),
    fieldSets: readInt32s(cursor, count, msg`field sets of specs`),
    types: readInt32s(cursor, count, msg`types of specs`),
  };
}
