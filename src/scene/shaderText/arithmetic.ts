import { degrees, radians } from '../../math/angle.ts';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { inverseOf } from './inverseMatrix.ts';
import type { ShaderOperation } from './program.ts';
import { isFloat, isInteger, type ShaderType } from './types.ts';

/*
 * What the operations of a shader text are, in f64. Truth is 1 and 0; matrices are column after column. Where WGSL leaves a result to the machine
 * (the root of a negative number) it is not a number.
 */

/** The components of a value of shader text. */
export type Components = readonly number[];
type ComponentFunction = (...args: number[]) => number;

const clampTo = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
/** Rounds half to even. */
function round(x: number): number {
  const low = Math.floor(x);
  const part = x - low;
  return part > 0.5 || (part === 0.5 && low % 2 !== 0) ? low + 1 : low;
}
function smoothstep(from: number, to: number, x: number): number {
  const t = clampTo((x - from) / (to - from), 0, 1);
  return t * t * (3 - 2 * t);
}
const whole = (x: number): number => x | 0;

/** Component-wise. */
const COMPONENTS: Readonly<Partial<Record<ShaderOperation, ComponentFunction>>> = {
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  sinh: Math.sinh,
  cosh: Math.cosh,
  tanh: Math.tanh,
  exp: Math.exp,
  exp2: (x) => 2 ** x,
  log: Math.log,
  log2: Math.log2,
  sqrt: Math.sqrt,
  inverseSqrt: (x) => 1 / Math.sqrt(x),
  floor: Math.floor,
  ceil: Math.ceil,
  round,
  trunc: Math.trunc,
  fract: (x) => x - Math.floor(x),
  radians,
  degrees,
  saturate: (x) => clampTo(x, 0, 1),
  pow: (x, y) => x ** y,
  atan2: Math.atan2,
  step: (edge, x) => (x >= edge ? 1 : 0),
  mix: (a, b, s) => a * (1 - s) + b * s,
  smoothstep,
  abs: Math.abs,
  sign: Math.sign,
  min: Math.min,
  max: Math.max,
  clamp: clampTo,
  negate: (x) => -x,
  not: (x) => 1 - x,
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  and: (a, b) => a * b,
  or: (a, b) => Math.max(a, b),
  eq: (a, b) => Number(a === b),
  ne: (a, b) => Number(a !== b),
  lt: (a, b) => Number(a < b),
  le: (a, b) => Number(a <= b),
  gt: (a, b) => Number(a > b),
  ge: (a, b) => Number(a >= b),
};

/** 32-bit integers; division by 0 leaves the dividend. */
const INTEGER_COMPONENTS: Readonly<Partial<Record<ShaderOperation, ComponentFunction>>> = {
  add: (a, b) => whole(a + b),
  sub: (a, b) => whole(a - b),
  mul: Math.imul,
  div: (a = 0, b = 0) => (b === 0 ? a : whole(a / b)),
  rem: (a, b) => (b === 0 ? 0 : a % b),
};
const FLOAT_COMPONENTS: Readonly<Partial<Record<ShaderOperation, ComponentFunction>>> = {
  div: (a, b) => a / b,
  rem: (a, b) => a - b * Math.trunc(a / b),
  mod: (a, b) => a - b * Math.floor(a / b),
};

const dot = (a: Components, b: Components): number => a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);
const length = (a: Components): number => Math.hypot(...a);

/** On whole vectors. */
const VECTORS: Readonly<Partial<Record<ShaderOperation, (a: Components, b: Components) => Components>>> = {
  dot: (a, b) => [dot(a, b)],
  length: (a) => [length(a)],
  distance: (a, b) => [length(a.map((x, i) => x - (b[i] ?? 0)))],
  normalize: (a) => a.map((x) => x / length(a)),
  cross: ([a = 0, b = 0, c = 0], [x = 0, y = 0, z = 0]) => [b * z - c * y, c * x - a * z, a * y - b * x],
  reflect: (a, n) => a.map((x, i) => x - 2 * dot(n, a) * (n[i] ?? 0)),
};

/** Evaluates an operation; scalars are broadcast to the number of components. */
export function applyOperation(
  f: ShaderOperation,
  args: readonly Components[],
  types: readonly ShaderType[],
): Components {
  const [a = [], b = [], c = []] = args;
  if (f === 'select') return c[0] ? b : a;
  if (f === 'product') return product(a, b, types[0] as ShaderType, types[1] as ShaderType);
  const matrix = types[0];
  if (f === 'transpose' && matrix)
    return a.map((_, i) => a[Math.floor(i / matrix.rows) + matrix.rows * (i % matrix.rows)] ?? 0);
  if (f === 'inverse' && matrix) return inverse(a, matrix.rows);
  const ofVectors = VECTORS[f];
  if (ofVectors) return ofVectors(a, b);
  const special = types[0] && isFloat(types[0]) ? FLOAT_COMPONENTS[f] : INTEGER_COMPONENTS[f];
  const each = special ?? COMPONENTS[f];
  if (!each) throw new MessageError(msg`no operation ${f}`);
  const size = Math.max(...args.map((arg) => arg.length));
  return Array.from({ length: size }, (_, i) => each(...args.map((arg) => arg[arg.length === 1 ? 0 : i] ?? 0)));
}

/** Matrix product: each column of b combines a's columns. A vector on the left is a row vector. */
function product(a: Components, b: Components, left: ShaderType, right: ShaderType): Components {
  const row = left.columns === 1;
  const [rows, inner, columns] = row ? [1, left.rows, right.columns] : [left.rows, left.columns, right.columns];
  const at = (m: Components, stride: number, i: number, j: number): number => m[j * stride + i] ?? 0;
  return Array.from({ length: rows * columns }, (_, n) => {
    const [i, j] = [n % rows, Math.floor(n / rows)];
    let sum = 0;
    for (let k = 0; k < inner; k++) sum += (row ? (a[k] ?? 0) : at(a, rows, i, k)) * at(b, inner, k, j);
    return sum;
  });
}

const inverse = (m: Components, size: number): Components =>
  inverseOf(size, (i) => m[i] ?? 0, {
    add: (a, b) => a + b,
    multiply: (a, b) => a * b,
    negate: (a) => -a,
    divide: (a, b) => a / b,
  });

/** A scalar on the diagonal of a matrix, or a matrix in another size, filled up by the identity. */
export const reshapeMatrix = (numbers: Components, from: ShaderType, to: ShaderType): Components =>
  Array.from({ length: to.rows * to.columns }, (_, i) => {
    const [row, column] = [i % to.rows, Math.floor(i / to.rows)];
    if (from.columns === 1) return row === column ? (numbers[0] ?? 0) : 0;
    if (row >= from.rows || column >= from.columns) return row === column ? 1 : 0;
    return numbers[column * from.rows + row] ?? 0;
  });

/** Converts to the component type. */
export function convertComponents(numbers: Components, to: ShaderType): Components {
  if (to.of === 'bool') return numbers.map((x) => Number(x !== 0));
  return isInteger(to) ? numbers.map((x) => whole(Math.trunc(x))) : numbers;
}
