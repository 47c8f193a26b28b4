import { msg } from '../../messages/message.ts';
import { applyOperation } from './arithmetic.ts';
import { LARGEST } from './literals.ts';
import {
  NUMBER_FUNCTIONS,
  type ShaderBinaryOperation,
  type ShaderExpression,
  type ShaderOperation,
  VECTOR_FUNCTIONS,
} from './program.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import {
  BOOL,
  commonComponentType,
  componentCount,
  concreteType,
  expectType,
  isFloat,
  isSameType,
  type ShaderType,
  sameShape,
  typeName,
} from './types.ts';

const BINARY: Readonly<Record<string, ShaderBinaryOperation>> = {
  ...{ '+': 'add', '-': 'sub', '*': 'mul', '/': 'div', '%': 'rem', '&&': 'and', '||': 'or' },
  ...{ '==': 'eq', '!=': 'ne', '<': 'lt', '<=': 'le', '>': 'gt', '>=': 'ge' },
};
const COMPARISONS = new Set<ShaderOperation>(['eq', 'ne', 'lt', 'le', 'gt', 'ge']);
/** Functions whose second and later arguments may be scalars in GLSL, or whose first ones may. */
const SPREADING = new Set<ShaderOperation>(['min', 'max', 'clamp', 'mod', 'mix', 'step', 'smoothstep']);

export const constants = (values: readonly ShaderExpression[]): readonly (readonly number[])[] | undefined => {
  const numbers = values.map((value) => (value.op === 'constant' ? value.numbers : undefined));
  return numbers.every((list) => list !== undefined) ? numbers : undefined;
};

/** Constant folding. */
export function operation(
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

export function unary(sign: string, of: ShaderExpression, at: SourceLocation): ShaderExpression {
  if (sign === '!') {
    expectType(of.type, BOOL, at, msg`what follows !`);
    return operation('not', [of], BOOL, at);
  }
  if (of.type.of === 'bool' || of.type.of === 'pixel') refuse(at, msg`- does not work on ${typeName(of.type)}`);
  return operation('negate', [of], of.type, at);
}

export function binary(sign: string, a: ShaderExpression, b: ShaderExpression, at: SourceLocation): ShaderExpression {
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

export function partsOf(of: ShaderExpression, parts: readonly number[]): ShaderExpression {
  const type: ShaderType = { ...of.type, rows: parts.length };
  return of.op === 'constant'
    ? { op: 'constant', type, numbers: parts.map((part) => of.numbers[part] ?? 0) }
    : { op: 'parts', type, of, parts };
}

/** GLSL's arguments of a function: scalars among vectors as vectors of their size, where it takes them. */
export function spread(f: ShaderOperation, args: readonly ShaderExpression[]): readonly ShaderExpression[] {
  const wide = args.find(({ type }) => type.columns === 1 && type.rows > 1);
  if (!wide || !SPREADING.has(f)) return args;
  return args.map((arg) => {
    if (componentCount(arg.type) !== 1) return arg;
    const type: ShaderType = { ...arg.type, rows: wide.type.rows };
    if (arg.op !== 'constant') return { op: 'build', type, parts: [arg] };
    return { op: 'constant', type, numbers: Array.from({ length: type.rows }, () => arg.numbers[0] ?? 0) };
  });
}

export function builtin(f: ShaderOperation, args: readonly ShaderExpression[], at: SourceLocation): ShaderExpression {
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
