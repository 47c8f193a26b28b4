import { apply, convert } from './arithmetic.ts';
import { type Place, refuse } from './place.ts';
import {
  type Binary,
  CHANNELS,
  type Channel,
  FLOAT_FUNCTIONS,
  INPUTS,
  type Input,
  NUMBER_FUNCTIONS,
  type Operation,
  type Value,
  VECTOR_FUNCTIONS,
} from './program.ts';
import type { Expression, TypeName } from './syntax.ts';
import {
  BOOL,
  becomes,
  commonOf,
  concrete,
  expectType,
  F32,
  isFloat,
  isSame,
  nameOf,
  sameShape,
  sizeOf,
  type Type,
  typeNamed,
  vector,
} from './types.ts';

/** What names stand for where an expression is. */
export interface Names {
  variable(name: string): Value | undefined;
  function(
    name: string,
  ): { readonly index: number; readonly params: readonly Type[]; readonly result: Type } | undefined;
}

/** Nearly the largest f32. */
const LARGEST = 3.4e38;
const BINARY: Readonly<Record<string, Binary>> = {
  ...{ '+': 'add', '-': 'sub', '*': 'mul', '/': 'div', '%': 'rem', '&&': 'and', '||': 'or' },
  ...{ '==': 'eq', '!=': 'ne', '<': 'lt', '<=': 'le', '>': 'gt', '>=': 'ge' },
};
const COMPARISONS = new Set<Operation>(['eq', 'ne', 'lt', 'le', 'gt', 'ge']);
const FUNCTIONS: Readonly<Record<string, number>> = {
  ...FLOAT_FUNCTIONS,
  ...NUMBER_FUNCTIONS,
  ...VECTOR_FUNCTIONS,
  select: 3,
};

/** Names that a text may not give to its own functions. */
export const isTaken = (name: string): boolean =>
  Object.hasOwn(FUNCTIONS, name) ||
  Object.hasOwn(CHANNELS, name) ||
  typeNamed({ at: { line: 1, column: 1 }, name }) !== undefined;

export function checked(of: Expression, names: Names): Value {
  switch (of.kind) {
    case 'number':
      return literal(of.text, of.at);
    case 'truth':
      return { op: 'constant', type: BOOL, numbers: [Number(of.value)] };
    case 'name':
      return named(of.name, of.at, names);
    case 'unary':
      return unary(of.sign, checked(of.of, names), of.at);
    case 'binary':
      return binary(of.sign, checked(of.a, names), checked(of.b, names), of.at);
    case 'member':
      return member(of.of, of.name, of.at, names);
    case 'index':
      return indexed(checked(of.of, names), checked(of.index, names), of.at);
    case 'call':
      return called(
        of.callee,
        of.args.map((arg) => checked(arg, names)),
        of.args.map(({ at }) => at),
        of.at,
        names,
      );
  }
}

function literal(text: string, at: Place): Value {
  const suffix = /^0[xX]/.test(text) ? /[iu]$/.exec(text)?.[0] : /[fhiu]$/.exec(text)?.[0];
  if (suffix === 'u' || suffix === 'h')
    refuse(at, `the number ${text} is of a type that is not taken: leave the ${suffix} out`);
  const value = Number(suffix ? text.slice(0, -1) : text);
  const broken = suffix === 'f' || (!/^0[xX]/.test(text) && /[.eE]/.test(text));
  if (!broken && value > 2 ** 31 - 1)
    refuse(at, `${text} is more than the largest i32, 2147483647: write it with a point`);
  if (Math.abs(value) > LARGEST) refuse(at, `${text} is more than the largest f32, 3.4e38`);
  const of = suffix === 'f' ? 'f32' : suffix === 'i' ? 'i32' : broken ? 'broken' : 'whole';
  return { op: 'constant', type: { of, rows: 1, columns: 1 }, numbers: [value] };
}

function named(name: string, at: Place, names: Names): Value {
  const variable = names.variable(name);
  if (variable) return variable;
  if (Object.hasOwn(INPUTS, name)) return { op: 'input', type: vector(INPUTS[name as Input]), input: name as Input };
  return refuse(at, `${name} is not declared here: \`let ${name} = …;\` before it, or is it spelt otherwise?`);
}

const constants = (values: readonly Value[]): readonly (readonly number[])[] | undefined => {
  const numbers = values.map((value) => (value.op === 'constant' ? value.numbers : undefined));
  return numbers.every((list) => list !== undefined) ? numbers : undefined;
};

/** What is known beforehand is worked out beforehand. */
function operation(f: Operation, args: readonly Value[], type: Type, at: Place): Value {
  const divisor = f === 'div' || f === 'rem' ? args[1] : undefined;
  if (divisor?.op === 'constant' && !isFloat(divisor.type) && divisor.numbers.includes(0))
    refuse(at, 'this divides a whole number by 0');
  const known = constants(args);
  if (!known) return { op: 'apply', type, f, args: args.map((arg) => as(arg, concrete(arg.type))) };
  const numbers = apply(
    f,
    known,
    args.map((arg) => arg.type),
  );
  if (numbers.some((x) => !(Math.abs(x) <= LARGEST))) refuse(at, 'this comes to no number that f32 holds');
  const size = sizeOf(type);
  return {
    op: 'constant',
    type,
    numbers: numbers.length === size ? numbers : Array.from({ length: size }, () => numbers[0] ?? 0),
  };
}

/** A value as a type that it becomes. */
export function as(value: Value, type: Type): Value {
  if (isSame(value.type, type)) return value;
  return value.op === 'constant' ? { ...value, type } : { op: 'convert', type, of: value };
}

function unary(sign: string, of: Value, at: Place): Value {
  if (sign === '!') {
    expectType(of.type, BOOL, at, 'what follows !');
    return operation('not', [of], BOOL, at);
  }
  if (of.type.of === 'bool' || of.type.of === 'pixel') refuse(at, `- does not work on ${nameOf(of.type)}`);
  return operation('negate', [of], of.type, at);
}

function binary(sign: string, a: Value, b: Value, at: Place): Value {
  const f = BINARY[sign] as Binary;
  const clash = (): never =>
    refuse(at, `${sign} does not work between ${nameOf(a.type)} and ${nameOf(b.type)}: convert one of them`);
  if (f === 'and' || f === 'or') {
    if (!isSame(a.type, BOOL) || !isSame(b.type, BOOL)) clash();
    return operation(f, [a, b], BOOL, at);
  }
  const of = commonOf([a.type, b.type]);
  if (!of) return clash();
  const [matrices, numbers] = [a.type.columns > 1 || b.type.columns > 1, sizeOf(a.type) === 1 || sizeOf(b.type) === 1];
  if (matrices && f === 'mul' && !numbers) return matrixProduct(a, b, clash, at);
  if (COMPARISONS.has(f)) {
    if (sizeOf(a.type) > 1 || sizeOf(b.type) > 1)
      refuse(at, `${sign} compares numbers: compare the components (.x, .y …) one by one`);
    if (of === 'bool' && f !== 'eq' && f !== 'ne') clash();
    return operation(f, [as(a, { ...a.type, of }), as(b, { ...b.type, of })], BOOL, at);
  }
  if (of === 'bool' || !(numbers || sameShape(a.type, b.type)) || (matrices && !['add', 'sub', 'mul'].includes(f)))
    clash();
  const shape = sizeOf(a.type) > 1 ? a.type : b.type;
  if (matrices && !sameShape(a.type, b.type) && f !== 'mul') clash();
  return operation(f, [as(a, { ...a.type, of }), as(b, { ...b.type, of })], { ...shape, of }, at);
}

function matrixProduct(a: Value, b: Value, clash: () => never, at: Place): Value {
  const row = a.type.columns === 1;
  if ((row ? a.type.rows : a.type.columns) !== b.type.rows) clash();
  const rows = row ? b.type.columns : a.type.rows;
  const type: Type = { of: 'f32', rows, columns: row ? 1 : b.type.columns };
  return operation('product', [as(a, { ...a.type, of: 'f32' }), as(b, { ...b.type, of: 'f32' })], type, at);
}

function member(written: Expression, name: string, at: Place, names: Names): Value {
  const of = checked(written, names);
  if (of.type.of === 'pixel') {
    const input = `p.${name}` as Input;
    if (name === 'color') return look('image', { op: 'constant', type: vector(2, 'i32'), numbers: [0, 0] });
    if (!Object.hasOwn(INPUTS, input))
      refuse(at, `a Pixel has no ${name}: it has position, uv, size, direction and color`);
    return { op: 'input', type: vector(INPUTS[input]), input };
  }
  const sets = ['xyzw', 'rgba'].map((set) => [...name].map((letter) => set.indexOf(letter)));
  const parts = sets.find((places) => places.every((place) => place >= 0 && place < of.type.rows));
  if (!parts || parts.length > 4 || of.type.rows === 1 || of.type.columns > 1)
    return refuse(at, `${nameOf(of.type)} has no .${name}`);
  return partsOf(of, parts);
}

function partsOf(of: Value, parts: readonly number[]): Value {
  const type: Type = { ...of.type, rows: parts.length };
  return of.op === 'constant'
    ? { op: 'constant', type, numbers: parts.map((part) => of.numbers[part] ?? 0) }
    : { op: 'parts', type, of, parts };
}

function indexed(of: Value, index: Value, at: Place): Value {
  const place = placeOf(index, at);
  const { rows, columns } = of.type;
  const count = columns > 1 ? columns : rows;
  if (count === 1 || place < 0 || place >= count) refuse(at, `${nameOf(of.type)} has no [${place}]`);
  if (columns === 1) return partsOf(of, [place]);
  const type: Type = { ...of.type, columns: 1 };
  return of.op === 'constant'
    ? { op: 'constant', type, numbers: of.numbers.slice(rows * place, rows * (place + 1)) }
    : { op: 'column', type, of, column: place };
}

/** An index that is known. */
export function placeOf(index: Value, at: Place): number {
  if (index.op !== 'constant' || isFloat(index.type) || sizeOf(index.type) !== 1)
    refuse(at, 'an index must be a whole number that is known: write [0], or .x');
  return index.op === 'constant' ? (index.numbers[0] ?? 0) : 0;
}

const look = (channel: Channel, offset: Value): Value => ({
  op: 'look',
  type: vector(CHANNELS[channel]),
  channel,
  offset,
});

function called(callee: TypeName, args: readonly Value[], places: readonly Place[], at: Place, names: Names): Value {
  const { name } = callee;
  const own = names.function(name);
  const counted = (count: number): void => {
    if (args.length !== count)
      refuse(at, `${name} takes ${count === 1 ? '1 value' : `${count} values`}, and has ${args.length}`);
  };
  if (own) {
    counted(own.params.length);
    for (const [i, type] of own.params.entries())
      expectType(args[i]?.type ?? type, type, places[i] ?? at, `value ${i + 1} of ${name}`);
    const passed = args.flatMap((arg, i) => (arg.type.of === 'pixel' ? [] : [as(arg, own.params[i] ?? arg.type)]));
    return { op: 'call', type: own.result, f: own.index, args: passed };
  }
  if (Object.hasOwn(CHANNELS, name)) {
    counted(1);
    expectType(args[0]?.type ?? F32, vector(2, 'i32'), places[0] ?? at, `the offset of ${name}, in pixels,`);
    return look(name as Channel, as(args[0] as Value, vector(2, 'i32')));
  }
  const count = FUNCTIONS[name];
  if (Object.hasOwn(FUNCTIONS, name) && count) {
    counted(count);
    return builtin(name as Operation, args, at);
  }
  const type = typeNamed(callee);
  if (type && type.of !== 'pixel') return constructed(type, args, at);
  return refuse(
    at,
    `there is no function ${name}: is it spelt otherwise? Textures, derivatives and bits are not taken`,
  );
}

function builtin(f: Operation, args: readonly Value[], at: Place): Value {
  const [a, b, c] = args as [Value, Value, Value];
  const clash = (): never => refuse(at, `${f} does not take (${args.map(({ type }) => nameOf(type)).join(', ')})`);
  if (f === 'select') {
    const of = commonOf([a.type, b.type]);
    if (!of || !sameShape(a.type, b.type) || !isSame(c.type, BOOL)) return clash();
    const type = { ...concrete({ ...a.type, of }) };
    return operation(f, [as(a, type), as(b, type), c], type, at);
  }
  // The last of `mix` may be a number for all components.
  const shares = f === 'mix' && sizeOf(c.type) === 1 ? [a, b] : args;
  const of = commonOf(args.map(({ type }) => type));
  const whole = Object.hasOwn(NUMBER_FUNCTIONS, f) && (of === 'whole' || of === 'i32');
  const wanted = whole ? of : of === 'whole' || of === 'broken' ? 'broken' : of === 'f32' ? 'f32' : undefined;
  if (!wanted || a.type.columns > 1 || shares.some(({ type }) => !sameShape(type, a.type))) return clash();
  const vectors = Object.hasOwn(VECTOR_FUNCTIONS, f);
  if (vectors && ((a.type.rows === 1 && f !== 'length' && f !== 'distance') || (f === 'cross' && a.type.rows !== 3)))
    clash();
  const single = f === 'dot' || f === 'length' || f === 'distance';
  const type: Type = { of: wanted, rows: single ? 1 : a.type.rows, columns: 1 };
  return operation(
    f,
    args.map((arg) => as(arg, { ...arg.type, of: wanted })),
    type,
    at,
  );
}

/** `vec3f(…)`, `f32(…)`, `mat2x2f(…)`. */
function constructed(type: Type, args: readonly Value[], at: Place): Value {
  const size = sizeOf(type);
  const bare = type.of === 'whole';
  const of = bare ? commonOf(args.map((arg) => arg.type)) : type.of;
  if (!of) return refuse(at, 'the values are of different types: convert them');
  const made: Type = { ...type, of };
  const one = args[0];
  if (!one) return { op: 'constant', type: concrete(made), numbers: Array.from({ length: size }, () => 0) };
  if (args.length === 1 && sameShape(one.type, type) && type.columns === 1) return converted(one, made, at);
  const total = args.reduce((sum, arg) => sum + sizeOf(arg.type), 0);
  const splat = args.length === 1 && sizeOf(one.type) === 1 && type.columns === 1;
  if (total !== size && !splat) refuse(at, `${nameOf(made)} has ${size} components, and is given ${total}`);
  const parts = args.map((arg, i) => {
    if (arg.type.of !== made.of && !becomes(arg.type, { ...arg.type, of: made.of }))
      refuse(at, `component ${i + 1} of ${nameOf(made)} is ${nameOf(arg.type)}: convert it by ${made.of}(…)`);
    return as(arg, { ...arg.type, of: made.of });
  });
  const known = constants(parts)?.flat();
  if (!known) return { op: 'build', type: made, parts };
  return { op: 'constant', type: made, numbers: splat ? Array.from({ length: size }, () => known[0] ?? 0) : known };
}

function converted(from: Value, to: Type, at: Place): Value {
  if (from.type.of === 'pixel') refuse(at, 'a Pixel is no number: take its position, uv, size, direction or color');
  if (from.op === 'constant') return { op: 'constant', type: to, numbers: convert(from.numbers, to) };
  return isSame(from.type, to) ? from : { op: 'convert', type: to, of: from };
}
