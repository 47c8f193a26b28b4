import { fromHalf, toHalf } from '../../../math/half.ts';
import { msg } from '../../../messages/message.ts';
import type { Dictionary, NumberArray, Value } from '../layer/layer.ts';
import type { Scanner } from './scanner.ts';
import { type ScalarKind, type TupleShape, type ValueType, valueTypes } from './valueTypes.ts';

/** Maximum depth of dictionaries, and of brackets in values of unknown types. */
const MAX_DEPTH = 64;

/** Parses a value of the given type (`float3[]`), or `None`, `AnimationBlock`. */
export function parseValue(s: Scanner, typeName: string, depth = 0): Value {
  const word = s.peekName();
  if (word === 'None' || word === 'AnimationBlock') {
    s.takeName();
    return { type: word === 'None' ? 'blocked' : 'animationBlock' };
  }
  if (typeName === 'dictionary') return { type: 'dictionary', data: parseDictionary(s, depth + 1) };
  const array = typeName.endsWith('[]');
  const type = valueTypes.get(array ? typeName.slice(0, -2) : typeName);
  if (!type) return rawValue(s);
  return array ? parseArray(s, type) : parseSingle(s, type);
}

function parseSingle(s: Scanner, type: ValueType): Value {
  switch (type.kind) {
    case 'bool':
      return { type: 'bool', data: parseBool(s) };
    case 'long':
      return { type: type.storage, data: parseLong(s, type.storage) };
    case 'text':
      return { type: type.storage, data: parseText(s, type.storage) };
    case 'number':
      return { type: type.storage, data: readScalar(s, type.scalar) };
    case 'tuple': {
      const data = newArray(type.scalar, type.shape.size);
      parseTuple(s, type.scalar, type.shape, data, 0);
      reorderQuaternions(type.storage, data);
      return { type: type.storage, data };
    }
  }
}

function parseArray(s: Scanner, type: ValueType): Value {
  switch (type.kind) {
    case 'text':
      return { type: `${type.storage}[]`, data: parseItems(s, () => parseText(s, type.storage)) };
    case 'long': {
      const items = parseItems(s, () => parseLong(s, type.storage));
      return type.storage === 'int64'
        ? { type: 'int64[]', data: BigInt64Array.from(items) }
        : { type: 'uint64[]', data: BigUint64Array.from(items) };
    }
    case 'bool':
      return { type: 'bool[]', data: Uint8Array.from(parseItems(s, () => (parseBool(s) ? 1 : 0))) };
    case 'number':
      return { type: `${type.storage}[]`, data: parseNumbers(s, type.scalar) };
    case 'tuple': {
      const data = parseNumbers(s, type.scalar, type.shape);
      reorderQuaternions(type.storage, data);
      return { type: `${type.storage}[]`, data };
    }
  }
}

/** `[a, b, …]`, with or without a comma at its end. */
export function parseItems<T>(s: Scanner, item: () => T): T[] {
  s.expect('[', msg`before a list`);
  const items: T[] = [];
  while (!s.take(']')) {
    items.push(item());
    if (!s.take(',') && s.peek() !== ']') s.expected(msg`',' or ']' in a list`);
  }
  return items;
}

/** Parses a list of numbers or tuples directly into one flat array. */
function parseNumbers(s: Scanner, scalar: ScalarKind, shape?: TupleShape): NumberArray {
  const size = shape?.size ?? 1;
  s.expect('[', msg`before a list`);
  let out = newArray(scalar, Math.ceil(countNumbers(s) / size) * size);
  let n = 0;
  while (!s.take(']')) {
    if (n + size > out.length) out = grown(out, scalar, n + size);
    if (!shape) out[n] = readScalar(s, scalar);
    else parseTuple(s, scalar, shape, out, n);
    n += size;
    if (!s.take(',') && s.peek() !== ']') s.expected(msg`',' or ']' in a list`);
  }
  return n === out.length ? out : out.slice(0, n);
}

/** Counts the numbers of a list by its commas; only comments in the list can make it inexact. */
function countNumbers(s: Scanner): number {
  const { bytes } = s;
  let count = s.peek() === ']' ? 0 : 1;
  for (let p = s.pos; p < bytes.length; p++) {
    const c = bytes[p];
    if (c === 44) count++;
    else if (c === 93) break;
  }
  return count;
}

function grown(from: NumberArray, scalar: ScalarKind, least: number): NumberArray {
  const to = newArray(scalar, Math.max(least, 2 * from.length));
  to.set(from);
  return to;
}

/** `(a, b)` or, for matrices, `((a, b), (c, d))`. */
function parseTuple(s: Scanner, scalar: ScalarKind, shape: TupleShape, out: NumberArray, at: number): void {
  const { parts, part } = shape;
  s.expect('(', shape.before);
  for (let i = 0; i < parts; i++) {
    if (i > 0) s.expect(',', shape.between);
    if (part) parseTuple(s, scalar, part, out, at + i * part.size);
    else out[at + i] = readScalar(s, scalar);
  }
  s.take(',');
  s.expect(')', shape.after);
}

function newArray(scalar: ScalarKind, length: number): NumberArray {
  switch (scalar) {
    case 'uchar':
      return new Uint8Array(length);
    case 'int':
      return new Int32Array(length);
    case 'uint':
      return new Uint32Array(length);
    case 'double':
      return new Float64Array(length);
    default:
      return new Float32Array(length);
  }
}

/** Least and greatest of each whole-number type. */
const LIMITS = { uchar: [0, 255], int: [-(2 ** 31), 2 ** 31 - 1], uint: [0, 2 ** 32 - 1] } as const;

function readScalar(s: Scanner, scalar: ScalarKind): number {
  const value = s.number();
  if (scalar === 'double') return value;
  if (scalar === 'float') return Math.fround(value);
  if (scalar === 'half') return fromHalf(toHalf(value));
  const [least, most] = LIMITS[scalar];
  const whole = Math.trunc(value);
  if (!(whole >= least && whole <= most)) s.fail(msg`${value} is not a whole number from ${least} to ${most}`);
  // −0 → 0.
  return whole + 0;
}

/** The text has w x y z; values are x y z w. */
function reorderQuaternions(storage: string, data: NumberArray): void {
  if (!storage.startsWith('quat')) return;
  for (let i = 0; i < data.length; i += 4) {
    const w = data[i];
    data.copyWithin(i, i + 1, i + 4);
    data[i + 3] = w;
  }
}

function parseBool(s: Scanner): boolean {
  const word = s.takeName()?.toLowerCase();
  if (word === undefined) return s.number() !== 0;
  if (word === 'true' || word === 'yes') return true;
  if (word === 'false' || word === 'no') return false;
  return s.fail(msg`'${word}' is not true, false, 0 or 1`);
}

function parseLong(s: Scanner, storage: 'int64' | 'uint64'): bigint {
  s.skip();
  const at = s.pos;
  const text = s.integerText();
  // 2⁶⁴ has 20 digits; much longer numbers are not converted.
  const value = text.length <= 40 ? BigInt(text) : 2n ** 64n;
  const fits = storage === 'int64' ? BigInt.asIntN(64, value) === value : BigInt.asUintN(64, value) === value;
  return fits ? value : s.fail(msg`${text.slice(0, 40)} does not fit ${storage}`, at);
}

function parseText(s: Scanner, storage: 'string' | 'token' | 'asset' | 'pathExpression'): string {
  return storage === 'asset' ? parseAsset(s) : s.string(msg`a ${storage} in quotes`);
}

/** `@file@` or `"file"`. */
function parseAsset(s: Scanner): string {
  const quoted = s.peek() === '"' || s.peek() === "'";
  const at = s.pos;
  const path = quoted ? s.string(msg`an asset path in quotes`) : s.asset();
  // biome-ignore lint/suspicious/noControlCharactersInRegex: these are what must not be there.
  if (/[\u0000-\u001f\u007f-\u009f]/.test(path)) s.fail(msg`this asset path has a control character`, at);
  return path;
}

/** `{ type name = value … }` */
export function parseDictionary(s: Scanner, depth = 0): Dictionary {
  if (depth > MAX_DEPTH) s.fail(msg`dictionaries are nested more than ${MAX_DEPTH} deep`);
  s.expect('{', msg`before a dictionary`);
  const entries = new Map<string, Value>();
  while (!s.take('}')) {
    const typeName = parseTypeName(s);
    const key = s.takeName() ?? s.string(msg`the name of a dictionary entry`);
    s.expect('=', msg`after '${key}'`);
    entries.set(key, parseValue(s, typeName, depth));
    s.endStatement(msg`the dictionary entry '${key}'`);
  }
  return entries;
}

/** `float`, `color3f[]`, `dictionary`. */
export function parseTypeName(s: Scanner): string {
  const name = s.name(msg`a type`);
  if (!s.take('[')) return name;
  s.expect(']', msg`after '${name}['`);
  return `${name}[]`;
}

/** The text of a value of unknown type, with balanced brackets. */
export function rawValue(s: Scanner): Value {
  s.skip();
  const start = s.pos;
  skipValue(s, 0);
  return { type: 'unregistered', data: s.text(start, s.pos) };
}

const CLOSING: Readonly<Record<string, string>> = { '(': ')', '[': ']', '{': '}' };

function skipValue(s: Scanner, depth: number): void {
  if (depth > MAX_DEPTH) s.fail(msg`brackets are nested more than ${MAX_DEPTH} deep`);
  const char = s.peek();
  const close = CLOSING[char];
  if (close) {
    s.pos++;
    while (!s.take(close)) skipInside(s, depth + 1);
  } else if (char === '"' || char === "'") s.string(msg`a string`);
  else if (char === '@') s.asset();
  else if (char === '<') s.path();
  else if (s.takeName() === undefined) s.number();
}

function skipInside(s: Scanner, depth: number): void {
  if (s.atEnd()) s.expected(msg`a closing bracket`);
  if (!',:;='.includes(s.peek())) skipValue(s, depth);
  else s.pos++;
}
