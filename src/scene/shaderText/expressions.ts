import { msg } from '../../messages/message.ts';
import { applyOperation, convertComponents, reshapeMatrix } from './arithmetic.ts';
import {
  FLOAT_FUNCTIONS,
  GLSL_FUNCTIONS,
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
import type { ExpressionSyntax, ModuleSyntax, TypeSyntax } from './syntax.ts';
import { typeNamed } from './typeNames.ts';
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
  scalar,
  typeName,
  vector,
} from './types.ts';

/** Scope of an expression. */
export interface ShaderScope {
  readonly language: ModuleSyntax['language'];
  /** GLSL's uniforms and inputs. */
  global(name: string): ExpressionSyntax | undefined;
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
  ...GLSL_FUNCTIONS,
  select: 3,
};
/** Functions whose second and later arguments may be scalars in GLSL, or whose first ones may. */
const SPREADING = new Set<ShaderOperation>(['min', 'max', 'clamp', 'mod', 'mix', 'step', 'smoothstep']);

/** Reserved function names. */
export const isReservedName = (name: string): boolean =>
  (Object.hasOwn(FUNCTIONS, name) && !Object.hasOwn(GLSL_FUNCTIONS, name)) ||
  Object.hasOwn(SHADER_CHANNELS, name) ||
  typeNamed({ at: { line: 1, column: 1 }, name }) !== undefined;

export function checkExpression(of: ExpressionSyntax, names: ShaderScope): ShaderExpression {
  switch (of.kind) {
    case 'number':
      return names.language === 'glsl' ? glslLiteral(of.text, of.at) : literal(of.text, of.at);
    case 'truth':
      return { op: 'constant', type: BOOL, numbers: [Number(of.value)] };
    case 'input':
      return inputExpression(of.input);
    case 'name':
      return named(of.name, of.at, names);
    case 'unary':
      return unary(of.sign, checkExpression(of.of, names), of.at);
    case 'binary':
      return binary(of.sign, checkExpression(of.a, names), checkExpression(of.b, names), of.at);
    case 'member':
      return member(of.of, of.name, of.at, names);
    case 'texel':
      return texel(of.channel, checkExpression(of.offset, names));
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

/** Whole numbers are ints, others floats. */
function glslLiteral(text: string, at: SourceLocation): ShaderExpression {
  const hex = /^0[xX]/.test(text);
  const suffix = hex ? undefined : /[uU]$|(?:lf|LF|[fF])$/.exec(text)?.[0];
  if (suffix === 'u' || suffix === 'U')
    refuse(at, msg`the number ${text} is of a type that is not taken: leave the ${suffix} out`);
  const digits = suffix ? text.slice(0, -suffix.length) : text;
  const found = literal(suffix && !/[.eE]/.test(digits) ? `${digits}.0` : digits, at);
  return { ...found, type: scalar(found.type.of === 'whole' ? 'int' : 'f32') };
}

/** The four components that GLSL reads from a texture with fewer. */
function texel(channel: ShaderChannel, offset: ShaderExpression): ShaderExpression {
  const value = sampleChannel(channel, convertTo(offset, vector(2, 'i32')));
  const size = SHADER_CHANNELS[channel];
  if (size === 4) return value;
  const rest = [0, 0, 0, 1].slice(size);
  const parts = [value, { op: 'constant', type: vector(rest.length), numbers: rest } as const];
  return { op: 'build', type: vector(4), parts };
}

const inputExpression = (input: ShaderInput): ShaderExpression => {
  const size = SHADER_INPUTS[input];
  return { op: 'input', type: size === 16 ? { of: 'f32', rows: 4, columns: 4 } : vector(size), input };
};

function named(name: string, at: SourceLocation, names: ShaderScope): ShaderExpression {
  const variable = names.variable(name);
  if (variable) return variable;
  const global = names.global(name);
  if (global) return checkExpression(global, names);
  // A text in GLSL declares what it takes.
  if (names.language === 'wgsl' && Object.hasOwn(SHADER_INPUTS, name)) return inputExpression(name as ShaderInput);
  return refuse(at, msg`${name} is not declared here: declare it before, or is it spelt otherwise?`);
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
      refuse(at, msg`a Pixel has no ${name}: it has position, uv, size, direction, view, projection and color`);
    return inputExpression(input);
  }
  const sets = ['xyzw', 'rgba', ...(names.language === 'glsl' ? ['stpq'] : [])].map((set) =>
    [...name].map((letter) => set.indexOf(letter)),
  );
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
  if (names.language === 'wgsl' && Object.hasOwn(SHADER_CHANNELS, name)) {
    counted(1);
    expectType(args[0]?.type ?? F32, vector(2, 'i32'), places[0] ?? at, msg`the offset of ${name}, in pixels,`);
    return sampleChannel(name as ShaderChannel, convertTo(args[0] as ShaderExpression, vector(2, 'i32')));
  }
  const count = FUNCTIONS[name];
  const isGlsl = names.language === 'glsl';
  if (Object.hasOwn(FUNCTIONS, name) && count && (isGlsl || !Object.hasOwn(GLSL_FUNCTIONS, name))) {
    counted(count);
    const f = name as ShaderOperation;
    return builtin(f, isGlsl && SPREADING.has(f) ? spread(args) : args, at);
  }
  const type = typeNamed(callee);
  if (type && type.of !== 'pixel') return isGlsl ? glslConstructed(type, args, at) : constructed(type, args, at);
  return refuse(
    at,
    msg`there is no function ${name}: is it spelt otherwise? Textures, derivatives and bits are not taken`,
  );
}

/** Scalars among vectors as vectors of their size. */
function spread(args: readonly ShaderExpression[]): readonly ShaderExpression[] {
  const wide = args.find(({ type }) => type.columns === 1 && type.rows > 1);
  if (!wide) return args;
  return args.map((arg) => {
    if (componentCount(arg.type) !== 1) return arg;
    const type: ShaderType = { ...arg.type, rows: wide.type.rows };
    if (arg.op !== 'constant') return { op: 'build', type, parts: [arg] };
    return { op: 'constant', type, numbers: Array.from({ length: type.rows }, () => arg.numbers[0] ?? 0) };
  });
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
  if (f === 'inverse' || f === 'transpose') {
    if (a.type.columns === 1) clash();
    return operation(f, [a], a.type, at);
  }
  // The last argument of `mix` may be a scalar.
  const shares = f === 'mix' && componentCount(c.type) === 1 ? [a, b] : args;
  const of = commonComponentType(args.map(({ type }) => type));
  const whole = Object.hasOwn(NUMBER_FUNCTIONS, f) && (of === 'whole' || of === 'i32' || of === 'int');
  const broken = of === 'whole' || of === 'broken';
  const wanted = whole ? of : broken ? 'broken' : of === 'f32' || of === 'int' ? 'f32' : undefined;
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

/** As `constructed`, but components of any type are converted, a vector may be cut short, and matrices are made of a number or another matrix. */
function glslConstructed(type: ShaderType, args: readonly ShaderExpression[], at: SourceLocation): ShaderExpression {
  const [one] = args;
  if (!one) return refuse(at, msg`${typeName(type)} has ${componentCount(type)} components, and is given ${0}`);
  const made = args.map((arg) => converted(arg, { ...arg.type, of: type.of }, at));
  const [first] = made as [ShaderExpression];
  if (made.length > 1) {
    const total = made.reduce((sum, arg) => sum + componentCount(arg.type), 0);
    const last = made.at(-1) as ShaderExpression;
    const excess = total - componentCount(type);
    // GLSL drops what the last value has too much.
    if (excess > 0 && excess < componentCount(last.type) && last.type.columns === 1) {
      const kept = Array.from({ length: componentCount(last.type) - excess }, (_, k) => k);
      return constructed(type, [...made.slice(0, -1), partsOf(last, kept)], at);
    }
    return constructed(type, made, at);
  }
  if (type.columns > 1) return matrixOfOne(type, first, at);
  if (first.type.columns === 1 && first.type.rows > type.rows) {
    const kept = Array.from({ length: type.rows }, (_, k) => k);
    return partsOf(first, kept);
  }
  return constructed(type, [first], at);
}

/** A multiple of the identity, or another matrix cut out or filled up by the identity. */
function matrixOfOne(type: ShaderType, one: ShaderExpression, at: SourceLocation): ShaderExpression {
  if (one.type.columns === 1 && one.type.rows > 1) refuse(at, msg`a matrix is not made of a vector`);
  if (one.op === 'constant') return { op: 'constant', type, numbers: reshapeMatrix(one.numbers, one.type, type) };
  return { op: 'reshape', type, of: one };
}

function converted(from: ShaderExpression, to: ShaderType, at: SourceLocation): ShaderExpression {
  if (from.type.of === 'pixel') refuse(at, msg`a Pixel is no number: take its position, uv, size, direction or color`);
  if (from.op === 'constant') return { op: 'constant', type: to, numbers: convertComponents(from.numbers, to) };
  return isSameType(from.type, to) ? from : { op: 'convert', type: to, of: from };
}
