import { msg } from '../../messages/message.ts';
import { constructed, glslConstructed } from './constructors.ts';
import { glslLiteral, literal } from './literals.ts';
import { binary, builtin, convertTo, partsOf, spread, unary } from './operations.ts';
import {
  FLOAT_FUNCTIONS,
  GLSL_FUNCTIONS,
  NUMBER_FUNCTIONS,
  SHADER_CHANNELS,
  SHADER_INPUTS,
  type ShaderChannel,
  type ShaderExpression,
  type ShaderInput,
  type ShaderOperation,
  VECTOR_FUNCTIONS,
} from './program.ts';
import { refuse, type SourceLocation } from './sourceLocation.ts';
import type { ExpressionSyntax, ModuleSyntax, TypeSyntax } from './syntax.ts';
import { typeNamed } from './typeNames.ts';
import { BOOL, componentCount, expectType, F32, isFloat, type ShaderType, typeName, vector } from './types.ts';

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

const FUNCTIONS: Readonly<Record<string, number>> = {
  ...FLOAT_FUNCTIONS,
  ...NUMBER_FUNCTIONS,
  ...VECTOR_FUNCTIONS,
  ...GLSL_FUNCTIONS,
  select: 3,
};
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
    return builtin(f, isGlsl ? spread(f, args) : args, at);
  }
  const type = typeNamed(callee);
  if (type && type.of !== 'pixel') return isGlsl ? glslConstructed(type, args, at) : constructed(type, args, at);
  return refuse(
    at,
    msg`there is no function ${name}: is it spelt otherwise? Textures, derivatives and bits are not taken`,
  );
}
