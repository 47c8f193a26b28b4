import { msg } from '../../messages/message.ts';
import { applyOperation, convertComponents } from './arithmetic.ts';
import {
  FLOAT_FUNCTIONS,
  NUMBER_FUNCTIONS,
  SHADER_CHANNELS,
  SHADER_INPUTS,
  type ShaderBinaryOperation,
  type ShaderChannel,
  type ShaderExpression,
  type ShaderInput,
  type ShaderOperation,
  VECTOR_FUNCTIONS,
} from './program.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import type { ExpressionSyntax, TypeSyntax } from './syntax.ts';
import {
  BOOL,
  commonComponentType,
  componentCount,
  concreteType,
  expectType,
  F32,
  isConvertible,
  isFloat,
  isSameType,
  type ShaderType,
  sameShape,
  typeName,
  typeNamed,
  vector,
} from './types.ts';

/** Scope of an expression. */
export interface ShaderScope {
  variable(name: string): ShaderExpression | undefined;
  function(
    name: string,
  ): { readonly index: number; readonly params: readonly ShaderType[]; readonly result: ShaderType } | undefined;
}

/** Nearly the largest f32. */
const LARGEST = 3.4e38;
const BINARY: Readonly<Record<string, ShaderBinaryOperation>> = {
  ...{ '+': 'add', '-': 'sub', '*': 'mul', '/': 'div', '%': 'rem', '&&': 'and', '||': 'or' },
  ...{ '==': 'eq', '!=': 'ne', '<': 'lt', '<=': 'le', '>': 'gt', '>=': 'ge' },
};
const COMPARISONS = new Set<ShaderOperation>(['eq', 'ne', 'lt', 'le', 'gt', 'ge']);
const FUNCTIONS: Readonly<Record<string, number>> = {
  ...FLOAT_FUNCTIONS,
  ...NUMBER_FUNCTIONS,
  ...VECTOR_FUNCTIONS,
  select: 3,
};

/** Reserved function names. */
export const isReservedName = (name: string): boolean =>
  Object.hasOwn(FUNCTIONS, name) ||
  Object.hasOwn(SHADER_CHANNELS, name) ||
  typeNamed({ at: { line: 1, column: 1 }, name }) !== undefined;

export function checkExpression(of: ExpressionSyntax, names: ShaderScope): ShaderExpression {
  switch (of.kind) {
    case 'number':
      return literal(of.text, of.at);
    case 'truth':
      return { op: 'constant', type: BOOL, numbers: [Number(of.value)] };
    case 'name':
      return named(of.name, of.at, names);
    case 'unary':
      return unary(of.sign, checkExpression(of.of, names), of.at);
    case 'binary':
      return binary(of.sign, checkExpression(of.a, names), checkExpression(of.b, names), of.at);
    case 'member':
      return member(of.of, of.name, of.at, names);
    case 'index':
      return indexed(checkExpression(of.of, names), checkExpression(of.index, names), of.at);
    case 'call':
      return called(
        of.callee,
        of.args.map((arg) => checkExpression(arg, names)),
        of.args.map(({ at }) => at),
        of.at,
        names,
      );
  }
}

function literal(text: string, at: SourceLocation): ShaderExpression {
  const suffix = /^0[xX]/.test(text) ? /[iu]$/.exec(text)?.[0] : /[fhiu]$/.exec(text)?.[0];
  if (suffix === 'u' || suffix === 'h')
    refuse(at, msg`the number ${text} is of a type that is not taken: leave the ${suffix} out`);
  const value = Number(suffix ? text.slice(0, -1) : text);
  const broken = suffix === 'f' || (!/^0[xX]/.test(text) && /[.eE]/.test(text));
  if (!broken && value > 2 ** 31 - 1)
    refuse(at, msg`${text} is more than the largest i32, 2147483647: write it with a point`);
  if (Math.abs(value) > LARGEST) refuse(at, msg`${text} is more than the largest f32, 3.4e38`);
  const of = suffix === 'f' ? 'f32' : suffix === 'i' ? 'i32' : broken ? 'broken' : 'whole';
  return { op: 'constant', type: { of, rows: 1, columns: 1 }, numbers: [value] };
}

function named(name: string, at: SourceLocation, names: ShaderScope): ShaderExpression {
  const variable = names.variable(name);
  if (variable) return variable;
  if (Object.hasOwn(SHADER_INPUTS, name))
    return { op: 'input', type: vector(SHADER_INPUTS[name as ShaderInput]), input: name as ShaderInput };
  return refuse(at, msg`${name} is not declared here: \`let ${name} = …;\` before it, or is it spelt otherwise?`);
}

const constants = (values: readonly ShaderExpression[]): readonly (readonly number[])[] | undefined => {
  const numbers = values.map((value) => (value.op === 'constant' ? value.numbers : undefined));
  return numbers.every((list) => list !== undefined) ? numbers : undefined;
};

/** Constant folding. */
function operation(
  f: ShaderOperation,
  args: readonly ShaderExpression[],
  type: ShaderType,
  at: SourceLocation,
): ShaderExpression {
  const divisor = f === 'div' || f === 'rem' ? args[1] : undefined;
  if (divisor?.op === 'constant' && !isFloat(divisor.type) && divisor.numbers.includes(0))
    refuse(at, msg`this divides a whole number by 0`);
  const known = constants(args);
  if (!known) return { op: 'apply', type, f, args: args.map((arg) => convertTo(arg, concreteType(arg.type))) };
  const numbers = applyOperation(
    f,
    known,
    args.map((arg) => arg.type),
  );
  if (numbers.some((x) => !(Math.abs(x) <= LARGEST))) refuse(at, msg`this comes to no number that f32 holds`);
  const size = componentCount(type);
  return {
    op: 'constant',
    type,
    numbers: numbers.length === size ? numbers : Array.from({ length: size }, () => numbers[0] ?? 0),
  };
}

/** Implicit conversion. */
export function convertTo(value: ShaderExpression, type: ShaderType): ShaderExpression {
  if (isSameType(value.type, type)) return value;
  return value.op === 'constant' ? { ...value, type } : { op: 'convert', type, of: value };
}

function unary(sign: string, of: ShaderExpression, at: SourceLocation): ShaderExpression {
  if (sign === '!') {
    expectType(of.type, BOOL, at, msg`what follows !`);
    return operation('not', [of], BOOL, at);
  }
  if (of.type.of === 'bool' || of.type.of === 'pixel') refuse(at, msg`- does not work on ${typeName(of.type)}`);
  return operation('negate', [of], of.type, at);
}

function binary(sign: string, a: ShaderExpression, b: ShaderExpression, at: SourceLocation): ShaderExpression {
  const f = BINARY[sign] as ShaderBinaryOperation;
  const clash = (): never =>
    refuse(at, msg`${sign} does not work between ${typeName(a.type)} and ${typeName(b.type)}: convert one of them`);
  if (f === 'and' || f === 'or') {
    if (!isSameType(a.type, BOOL) || !isSameType(b.type, BOOL)) clash();
    return operation(f, [a, b], BOOL, at);
  }
  const of = commonComponentType([a.type, b.type]);
  if (!of) return clash();
  const [matrices, numbers] = [
    a.type.columns > 1 || b.type.columns > 1,
    componentCount(a.type) === 1 || componentCount(b.type) === 1,
  ];
  if (matrices && f === 'mul' && !numbers) return matrixProduct(a, b, clash, at);
  if (COMPARISONS.has(f)) {
    if (componentCount(a.type) > 1 || componentCount(b.type) > 1)
      refuse(at, msg`${sign} compares numbers: compare the components (.x, .y …) one by one`);
    if (of === 'bool' && f !== 'eq' && f !== 'ne') clash();
    return operation(f, [convertTo(a, { ...a.type, of }), convertTo(b, { ...b.type, of })], BOOL, at);
  }
  if (of === 'bool' || !(numbers || sameShape(a.type, b.type)) || (matrices && !['add', 'sub', 'mul'].includes(f)))
    clash();
  const shape = componentCount(a.type) > 1 ? a.type : b.type;
  if (matrices && !sameShape(a.type, b.type) && f !== 'mul') clash();
  return operation(f, [convertTo(a, { ...a.type, of }), convertTo(b, { ...b.type, of })], { ...shape, of }, at);
}

function matrixProduct(
  a: ShaderExpression,
  b: ShaderExpression,
  clash: () => never,
  at: SourceLocation,
): ShaderExpression {
  const row = a.type.columns === 1;
  if ((row ? a.type.rows : a.type.columns) !== b.type.rows) clash();
  const rows = row ? b.type.columns : a.type.rows;
  const type: ShaderType = { of: 'f32', rows, columns: row ? 1 : b.type.columns };
  return operation(
    'product',
    [convertTo(a, { ...a.type, of: 'f32' }), convertTo(b, { ...b.type, of: 'f32' })],
    type,
    at,
  );
}

function member(written: ExpressionSyntax, name: string, at: SourceLocation, names: ShaderScope): ShaderExpression {
  const of = checkExpression(written, names);
  if (of.type.of === 'pixel') {
    const input = `p.${name}` as ShaderInput;
    if (name === 'color') return sampleChannel('image', { op: 'constant', type: vector(2, 'i32'), numbers: [0, 0] });
    if (!Object.hasOwn(SHADER_INPUTS, input))
      refuse(at, msg`a Pixel has no ${name}: it has position, uv, size, direction and color`);
    return { op: 'input', type: vector(SHADER_INPUTS[input]), input };
  }
  const sets = ['xyzw', 'rgba'].map((set) => [...name].map((letter) => set.indexOf(letter)));
  const parts = sets.find((places) => places.every((place) => place >= 0 && place < of.type.rows));
  if (!parts || parts.length > 4 || of.type.rows === 1 || of.type.columns > 1)
    return refuse(at, msg`${typeName(of.type)} has no .${name}`);
  return partsOf(of, parts);
}

function partsOf(of: ShaderExpression, parts: readonly number[]): ShaderExpression {
  const type: ShaderType = { ...of.type, rows: parts.length };
  return of.op === 'constant'
    ? { op: 'constant', type, numbers: parts.map((part) => of.numbers[part] ?? 0) }
    : { op: 'parts', type, of, parts };
}

function indexed(of: ShaderExpression, index: ShaderExpression, at: SourceLocation): ShaderExpression {
  const place = constantIndex(index, at);
  const { rows, columns } = of.type;
  const count = columns > 1 ? columns : rows;
  if (count === 1 || place < 0 || place >= count) refuse(at, msg`${typeName(of.type)} has no [${place}]`);
  if (columns === 1) return partsOf(of, [place]);
  const type: ShaderType = { ...of.type, columns: 1 };
  return of.op === 'constant'
    ? { op: 'constant', type, numbers: of.numbers.slice(rows * place, rows * (place + 1)) }
    : { op: 'column', type, of, column: place };
}

/** A constant index. */
export function constantIndex(index: ShaderExpression, at: SourceLocation): number {
  if (index.op !== 'constant' || isFloat(index.type) || componentCount(index.type) !== 1)
    refuse(at, msg`an index must be a whole number that is known: write [0], or .x`);
  return index.op === 'constant' ? (index.numbers[0] ?? 0) : 0;
}

const sampleChannel = (channel: ShaderChannel, offset: ShaderExpression): ShaderExpression => ({
  op: 'look',
  type: vector(SHADER_CHANNELS[channel]),
  channel,
  offset,
});

function called(
  callee: TypeSyntax,
  args: readonly ShaderExpression[],
  places: readonly SourceLocation[],
  at: SourceLocation,
  names: ShaderScope,
): ShaderExpression {
  const { name } = callee;
  const own = names.function(name);
  const counted = (count: number): void => {
    if (args.length !== count)
      refuse(at, msg`${name} takes ${count === 1 ? msg`1 value` : msg`${count} values`}, and has ${args.length}`);
  };
  if (own) {
    counted(own.params.length);
    for (const [i, type] of own.params.entries())
      expectType(args[i]?.type ?? type, type, places[i] ?? at, msg`value ${i + 1} of ${name}`);
    const passed = args.flatMap((arg, i) =>
      arg.type.of === 'pixel' ? [] : [convertTo(arg, own.params[i] ?? arg.type)],
    );
    return { op: 'call', type: own.result, f: own.index, args: passed };
  }
  if (Object.hasOwn(SHADER_CHANNELS, name)) {
    counted(1);
    expectType(args[0]?.type ?? F32, vector(2, 'i32'), places[0] ?? at, msg`the offset of ${name}, in pixels,`);
    return sampleChannel(name as ShaderChannel, convertTo(args[0] as ShaderExpression, vector(2, 'i32')));
  }
  const count = FUNCTIONS[name];
  if (Object.hasOwn(FUNCTIONS, name) && count) {
    counted(count);
    return builtin(name as ShaderOperation, args, at);
  }
  const type = typeNamed(callee);
  if (type && type.of !== 'pixel') return constructed(type, args, at);
  return refuse(
    at,
    msg`there is no function ${name}: is it spelt otherwise? Textures, derivatives and bits are not taken`,
  );
}

function builtin(f: ShaderOperation, args: readonly ShaderExpression[], at: SourceLocation): ShaderExpression {
  const [a, b, c] = args as [ShaderExpression, ShaderExpression, ShaderExpression];
  const clash = (): never => refuse(at, msg`${f} does not take (${args.map(({ type }) => typeName(type)).join(', ')})`);
  if (f === 'select') {
    const of = commonComponentType([a.type, b.type]);
    if (!of || !sameShape(a.type, b.type) || !isSameType(c.type, BOOL)) return clash();
    const type = { ...concreteType({ ...a.type, of }) };
    return operation(f, [convertTo(a, type), convertTo(b, type), c], type, at);
  }
  // The last argument of `mix` may be a scalar.
  const shares = f === 'mix' && componentCount(c.type) === 1 ? [a, b] : args;
  const of = commonComponentType(args.map(({ type }) => type));
  const whole = Object.hasOwn(NUMBER_FUNCTIONS, f) && (of === 'whole' || of === 'i32');
  const wanted = whole ? of : of === 'whole' || of === 'broken' ? 'broken' : of === 'f32' ? 'f32' : undefined;
  if (!wanted || a.type.columns > 1 || shares.some(({ type }) => !sameShape(type, a.type))) return clash();
  const vectors = Object.hasOwn(VECTOR_FUNCTIONS, f);
  if (vectors && ((a.type.rows === 1 && f !== 'length' && f !== 'distance') || (f === 'cross' && a.type.rows !== 3)))
    clash();
  const single = f === 'dot' || f === 'length' || f === 'distance';
  const type: ShaderType = { of: wanted, rows: single ? 1 : a.type.rows, columns: 1 };
  return operation(
    f,
    args.map((arg) => convertTo(arg, { ...arg.type, of: wanted })),
    type,
    at,
  );
}

/** `vec3f(…)`, `f32(…)`, `mat2x2f(…)`. */
function constructed(type: ShaderType, args: readonly ShaderExpression[], at: SourceLocation): ShaderExpression {
  const size = componentCount(type);
  const bare = type.of === 'whole';
  const of = bare ? commonComponentType(args.map((arg) => arg.type)) : type.of;
  if (!of) return refuse(at, msg`the values are of different types: convert them`);
  const made: ShaderType = { ...type, of };
  const one = args[0];
  if (!one) return { op: 'constant', type: concreteType(made), numbers: Array.from({ length: size }, () => 0) };
  if (args.length === 1 && sameShape(one.type, type) && type.columns === 1) return converted(one, made, at);
  const total = args.reduce((sum, arg) => sum + componentCount(arg.type), 0);
  const splat = args.length === 1 && componentCount(one.type) === 1 && type.columns === 1;
  if (total !== size && !splat) refuse(at, msg`${typeName(made)} has ${size} components, and is given ${total}`);
  const parts = args.map((arg, i) => {
    if (arg.type.of !== made.of && !isConvertible(arg.type, { ...arg.type, of: made.of }))
      refuse(at, msg`component ${i + 1} of ${typeName(made)} is ${typeName(arg.type)}: convert it by ${made.of}(…)`);
    return convertTo(arg, { ...arg.type, of: made.of });
  });
  const known = constants(parts)?.flat();
  if (!known) return { op: 'build', type: made, parts };
  return { op: 'constant', type: made, numbers: splat ? Array.from({ length: size }, () => known[0] ?? 0) : known };
}

function converted(from: ShaderExpression, to: ShaderType, at: SourceLocation): ShaderExpression {
  if (from.type.of === 'pixel') refuse(at, msg`a Pixel is no number: take its position, uv, size, direction or color`);
  if (from.op === 'constant') return { op: 'constant', type: to, numbers: convertComponents(from.numbers, to) };
  return isSameType(from.type, to) ? from : { op: 'convert', type: to, of: from };
}
