import {
  abs,
  acos,
  asin,
  atan,
  Break,
  bool,
  Continue,
  ceil,
  clamp,
  cos,
  cross,
  degrees,
  distance,
  dot,
  exp,
  exp2,
  float,
  floor,
  fract,
  If,
  int,
  inverseSqrt,
  ivec2,
  ivec3,
  ivec4,
  Loop,
  length,
  log,
  log2,
  mat2,
  mat3,
  mat4,
  max,
  min,
  mix,
  normalize,
  pow,
  radians,
  reflect,
  round,
  saturate,
  select,
  sign,
  sin,
  smoothstep,
  sqrt,
  step,
  tan,
  transpose,
  trunc,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { inverseOf } from '../../scene/shaderText/inverseMatrix.ts';
import type {
  ShaderChannel,
  ShaderExpression,
  ShaderFunction,
  ShaderInput,
  ShaderOperation,
  ShaderProgram,
  ShaderStatement,
} from '../../scene/shaderText/program.ts';
import { componentCount, isFloat, isInteger, type ShaderType, scalar, vector } from '../../scene/shaderText/types.ts';
import type { Bool, Float, Int, Vec2, Vec4 } from '../../shaders/types.ts';
import { type Effect, singleStep } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

/**
 * Compiles a user's shader program to nodes of three.js, for both backends. Three's types cannot follow a type that is data: here every node is a `Float` to
 * TypeScript, and its type on the GPU is that of the program, which is checked before (scene/shaderText/typeCheck.ts).
 */

const untyped = (node: unknown): Float => node as Float;
const asBool = (node: Float): Bool => node as unknown as Bool;
const asOffset = (node: Float): Vec2 => vec2(node as unknown as Vec2);

/** `written` of src/reference/post/effects/. */
export const compileShaderText = (program: ShaderProgram): Effect =>
  singleStep(
    (frame) =>
      new FunctionCompiler(
        program,
        program.functions[program.effect] as ShaderFunction,
        [],
        frame,
      ).result() as unknown as Vec4,
  );

const MATRICES = { 2: mat2, 3: mat3, 4: mat4 } as const;
const VECTORS = {
  f32: { 1: float, 2: vec2, 3: vec3, 4: vec4 },
  i32: { 1: int, 2: ivec2, 3: ivec3, 4: ivec4 },
  bool: { 1: bool },
} as const;

/** A value of a type, from its components in order. */
function build(type: ShaderType, parts: readonly Float[]): Float {
  const { rows, columns } = type;
  const of = isInteger(type) ? 'i32' : type.of;
  const tables: Readonly<Record<string, Readonly<Record<number, unknown>>>> = { ...VECTORS, matrix: MATRICES };
  const make = tables[columns > 1 ? 'matrix' : of]?.[columns > 1 ? columns : rows] as
    | ((...parts: Float[]) => unknown)
    | undefined;
  if (!make) throw new Error(`no type of ${rows} × ${columns} ${of}`);
  return untyped(make(...parts));
}

function constant(type: ShaderType, numbers: readonly number[]): Float {
  const { of, rows, columns } = type;
  const scalarConstant = (x: number): Float =>
    untyped(of === 'bool' ? bool(x !== 0) : isInteger(type) ? int(x) : float(x));
  if (componentCount(type) === 1) return scalarConstant(numbers[0] ?? 0);
  if (columns === 1) return build({ ...type, of: isFloat(type) ? 'f32' : 'i32' }, numbers.map(scalarConstant));
  // From numbers three.js would build a matrix row by row.
  const column = (k: number) => build(vector(rows), numbers.slice(k * rows, (k + 1) * rows).map(scalarConstant));
  return build(
    type,
    Array.from({ length: columns }, (_, k) => column(k)),
  );
}

/** An element of a matrix, column after column. */
const elementOf = (matrix: Float, rows: number, i: number): Float => {
  const column = (matrix as unknown as { element(k: Int): Float }).element(int(Math.floor(i / rows)));
  return swizzle(column, [i % rows]);
};

function reshaped(one: Float, from: ShaderType, to: ShaderType): Float {
  const parts = Array.from({ length: componentCount(to) }, (_, i) => {
    const [row, column] = [i % to.rows, Math.floor(i / to.rows)];
    if (from.columns === 1) return row === column ? one : float(0);
    if (row >= from.rows || column >= from.columns) return float(row === column ? 1 : 0);
    return elementOf(one, from.rows, column * from.rows + row);
  });
  return matrixOf(to, parts);
}

const inverted = (matrix: Float, type: ShaderType): Float =>
  matrixOf(
    type,
    inverseOf<Float>(type.rows, (i) => elementOf(matrix, type.rows, i), {
      add: (a, b) => a.add(b),
      multiply: (a, b) => a.mul(b),
      negate: (a) => a.negate(),
      divide: (a, b) => a.div(b),
    }),
  );

/** By columns, since three.js takes the elements of a matrix row after row. */
const matrixOf = (type: ShaderType, elements: readonly Float[]): Float =>
  build(
    type,
    Array.from({ length: type.columns }, (_, k) =>
      build(vector(type.rows), elements.slice(k * type.rows, (k + 1) * type.rows)),
    ),
  );

type Make = (...args: Float[]) => unknown;
const floatRemainder = (a: Float, b: Float): Float => a.sub(b.mul(trunc(a.div(b))));
const intRemainder = (a: Float, b: Float): Float => a.sub(b.mul(a.div(b)));

const OF_VECTORS = { dot, length, distance, normalize, reflect, cross };
const OPERATIONS: Readonly<Record<Exclude<ShaderOperation, 'inverse'>, Make>> = {
  ...{ sin, cos, tan, asin, acos, atan, exp, exp2, log, log2, sqrt, inverseSqrt, floor, ceil, round, trunc, fract },
  ...{ radians, degrees, saturate, pow, step, mix, smoothstep, abs, sign, min, max, clamp },
  ...(OF_VECTORS as unknown as Readonly<Record<keyof typeof OF_VECTORS, Make>>),
  atan2: (y, x) => atan(y, x),
  sinh: (x) => exp(x).sub(exp(x.negate())).div(2),
  cosh: (x) => exp(x).add(exp(x.negate())).div(2),
  tanh: (x) => exp(x.mul(2)).add(1).reciprocal().mul(2).oneMinus(),
  select: (no, yes, test) => select(asBool(test), yes, no),
  negate: (a) => a.negate(),
  not: (a) => asBool(a).not(),
  add: (a, b) => a.add(b),
  sub: (a, b) => a.sub(b),
  mul: (a, b) => a.mul(b),
  div: (a, b) => a.div(b),
  rem: floatRemainder,
  mod: (a, b) => a.sub(b.mul(floor(a.div(b)))),
  transpose: transpose as unknown as Make,
  product: (a, b) => a.mul(b),
  and: (a, b) => asBool(a).and(asBool(b)),
  or: (a, b) => asBool(a).or(asBool(b)),
  eq: (a, b) => a.equal(b),
  ne: (a, b) => a.notEqual(b),
  lt: (a, b) => a.lessThan(b),
  le: (a, b) => a.lessThanEqual(b),
  gt: (a, b) => a.greaterThan(b),
  ge: (a, b) => a.greaterThanEqual(b),
};

/** Whether a statement may return from its function. */
const mayReturn = (of: ShaderStatement): boolean =>
  of.op === 'return' ||
  (of.op === 'if' && [...of.yes, ...of.no].some(mayReturn)) ||
  (of.op === 'for' && of.body.some(mayReturn));

/** Compiles one function, inlined at each call. Shaders leave loops, and skip what follows a branch, by testing the variable `done`. */
class FunctionCompiler {
  private readonly program: ShaderProgram;
  private readonly definition: ShaderFunction;
  private readonly frame: EffectContext;
  private readonly locals: readonly Float[];
  private readonly returned: Float;
  private readonly done: Bool;

  constructor(program: ShaderProgram, of: ShaderFunction, args: readonly Float[], frame: EffectContext) {
    this.program = program;
    this.definition = of;
    this.frame = frame;
    this.locals = of.locals.map((type, i) => args[i] ?? this.variable(type));
    this.returned = this.variable(of.result);
    this.done = bool(false).toVar();
  }

  result(): Float {
    this.steps(this.definition.body, false);
    return this.returned;
  }

  private variable(type: ShaderType): Float {
    const zeros = Array.from({ length: componentCount(type) }, () => 0);
    return constant(type, zeros).toVar();
  }

  private steps(steps: readonly ShaderStatement[], looping: boolean): void {
    for (const [i, of] of steps.entries()) {
      this.step(of, looping);
      if (of.op === 'return' || of.op === 'break' || of.op === 'continue') return;
      if (!mayReturn(of)) continue;
      if (!looping) {
        If(this.done.not(), () => this.steps(steps.slice(i + 1), looping));
        return;
      }
      if (of.op === 'for') If(this.done, () => Break());
    }
  }

  private step(of: ShaderStatement, looping: boolean): void {
    switch (of.op) {
      case 'set':
        this.set(this.locals[of.local] as Float, of.part, this.value(of.value));
        return;
      case 'if':
        If(asBool(this.value(of.test)), () => this.steps(of.yes, looping)).Else(() => this.steps(of.no, looping));
        return;
      case 'for':
        this.loop(of);
        return;
      case 'return':
        this.returned.assign(this.value(of.value));
        this.done.assign(true);
        if (looping) Break();
        return;
      case 'break':
        Break();
        return;
      case 'continue':
        Continue();
    }
  }

  private set(local: Float, part: number | undefined, value: Float): void {
    if (part === undefined) local.assign(value);
    else untyped(swizzle(local, [part])).assign(value);
  }

  private loop({ local, first, by, count, body }: ShaderStatement & { readonly op: 'for' }): void {
    if (count === 0) return;
    Loop(count, ({ i }: { i: Int }) => {
      this.locals[local]?.assign(untyped(i.mul(by).add(first)));
      this.steps(body, true);
    });
  }

  private value(value: ShaderExpression): Float {
    switch (value.op) {
      case 'constant':
        return constant(value.type, value.numbers);
      case 'local':
        return this.locals[value.local] as Float;
      case 'input':
        return readInput(this.frame, value.input);
      case 'look':
        return readChannel(this.frame, value.channel, this.frame.pixel.add(asOffset(this.value(value.offset))).toVar());
      case 'parts':
        return swizzle(this.value(value.of), value.parts);
      case 'column':
        return untyped((this.value(value.of) as unknown as { element(i: Int): unknown }).element(int(value.column)));
      case 'build':
        return build(
          value.type,
          value.parts.map((part) => this.value(part)),
        );
      case 'convert':
        return build(value.type.columns > 1 ? value.type : { ...scalar(value.type.of), rows: value.type.rows }, [
          this.value(value.of),
        ]);
      case 'reshape':
        return reshaped(this.value(value.of).toVar(), value.of.type, value.type);
      case 'apply':
        return this.applied(value);
      case 'call': {
        const args = value.args.map((arg) => this.value(arg).toVar());
        return new FunctionCompiler(
          this.program,
          this.program.functions[value.f] as ShaderFunction,
          args,
          this.frame,
        ).result();
      }
    }
  }

  private applied({ f, args }: ShaderExpression & { readonly op: 'apply' }): Float {
    const values = args.map((arg) => this.value(arg));
    const { type } = args[0] as ShaderExpression;
    if (f === 'inverse') return inverted((values[0] as Float).toVar(), type);
    return untyped((f === 'rem' && !isFloat(type) ? intRemainder : OPERATIONS[f])(...values));
  }
}

const swizzle = (of: Float, parts: readonly number[]): Float =>
  untyped(Reflect.get(of, parts.map((part) => 'xyzw'[part]).join('')));

/** The value of a channel at a pixel; 0 where there is no surface. */
function readChannel(frame: EffectContext, channel: ShaderChannel, pixel: Vec2): Float {
  if (channel === 'image') return untyped(frame.image.at(pixel));
  if (channel === 'image2') return untyped(frame.secondImage(pixel));
  if (channel === 'object') return frame.object(pixel);
  const { x: exists, y: depth } = frame.depth(pixel).toVar();
  switch (channel) {
    case 'there':
      return exists;
    case 'depth':
      return depth.mul(exists);
    case 'normal':
      return untyped(frame.normal(pixel).mul(exists));
    case 'albedo':
      return untyped(frame.albedo(pixel).mul(exists));
    case 'roughness':
      return select(exists.greaterThan(0.5), frame.roughness(pixel), float(0));
    case 'metallic':
      return select(exists.greaterThan(0.5), frame.metallic(pixel), float(0));
    case 'metallicRoughness':
      return untyped(select(exists.greaterThan(0.5), vec2(frame.metallic(pixel), frame.roughness(pixel)), vec2(0)));
    case 'apparent':
      return untyped(frame.apparentPosition(pixel).mul(exists));
    case 'clipDepth':
      return select(exists.greaterThan(0.5), frame.clipDepth(pixel), float(0));
    case 'event':
      return untyped(frame.event(pixel).mul(exists));
    case 'emissionTime':
      return frame.emissionTime(pixel).mul(exists);
    case 'velocity':
      return untyped(frame.motion(pixel).xyz.mul(exists));
    case 'doppler':
      return frame.motion(pixel).w.mul(exists);
  }
}

function readInput(frame: EffectContext, name: ShaderInput): Float {
  const [arg1, arg2, arg3, arg4] = frame.args;
  const position = frame.pixel.add(0.5);
  const inputs: Readonly<Record<ShaderInput, () => unknown>> = {
    arg1: () => arg1,
    arg2: () => arg2,
    arg3: () => arg3,
    arg4: () => arg4,
    time: () => frame.time,
    'p.position': () => position,
    'p.uv': () => position.div(frame.image.size),
    'p.size': () => frame.image.size,
    'p.direction': () => frame.direction(),
    'p.view': () => frame.viewMatrix(),
    'p.projection': () => frame.projectionMatrix(),
  };
  return untyped(inputs[name]());
}
