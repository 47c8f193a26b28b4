import type { ShaderChannel, ShaderInput } from '../program.ts';
import type { SourceLocation } from '../sourceLocation.ts';
import type { ExpressionSyntax } from '../syntax.ts';
import { type ShaderType, scalar, vector } from '../types.ts';

/*
 * What the uniforms, inputs and samplers of a GLSL text mean. GLSL counts pixels from the bottom left, our programs from the top left.
 */

const MAT4: ShaderType = { of: 'f32', rows: 4, columns: 4 };
export const GLSL_TYPES: Readonly<Record<string, ShaderType>> = {
  float: scalar('f32'),
  int: scalar('int'),
  bool: scalar('bool'),
  ...{ vec2: vector(2), vec3: vector(3), vec4: vector(4) },
  ...{ ivec2: vector(2, 'int'), ivec3: vector(3, 'int'), ivec4: vector(4, 'int') },
  ...{ mat2: { of: 'f32', rows: 2, columns: 2 }, mat3: { of: 'f32', rows: 3, columns: 3 }, mat4: MAT4 },
  ...{ mat2x2: { of: 'f32', rows: 2, columns: 2 }, mat3x3: { of: 'f32', rows: 3, columns: 3 }, mat4x4: MAT4 },
};

/** A channel by what a sampler of it is called, without `Sampler`, `Texture`, `Map` … and in small letters. */
const SAMPLERS: Readonly<Record<string, ShaderChannel>> = {
  ...{ basecolor: 'image', basecolor1: 'image', color: 'image', color1: 'image', image: 'image', image1: 'image' },
  ...{ basecolor2: 'image2', color2: 'image2', image2: 'image2' },
  ...{ normal: 'normal', position: 'apparent', depth: 'clipDepth', diffusecolor: 'albedo', albedo: 'albedo' },
  ...{ metallicroughness: 'metallicRoughness', roughness: 'roughness', metallic: 'metallic' },
  ...{ velocity: 'velocity', doppler: 'doppler', event: 'event' },
};

export const channelOfSampler = (name: string): ShaderChannel | undefined => {
  const plain = name.toLowerCase().replace(/^u_|(?:_?(?:sampler|texture|map|tex))+(?=\d?$)/g, '');
  return Object.hasOwn(SAMPLERS, plain) ? SAMPLERS[plain] : undefined;
};

/** Names for messages. */
export const SAMPLER_EXAMPLES: readonly string[] = [
  ...['baseColorSampler', 'baseColorSampler2', 'positionSampler', 'normalSampler', 'depthSampler'],
  ...['diffuseColorSampler', 'metallicRoughnessSampler', 'velocitySampler', 'dopplerSampler', 'eventSampler'],
];

/** Makes syntax at a place. */
const syntaxAt = (at: SourceLocation) => {
  const number = (x: number): ExpressionSyntax => ({ at, kind: 'number', text: x.toFixed(1) });
  const member = (of: ExpressionSyntax, part: string): ExpressionSyntax => ({ at, kind: 'member', of, name: part });
  const binary = (sign: string, a: ExpressionSyntax, b: ExpressionSyntax): ExpressionSyntax => ({
    ...{ at, kind: 'binary', sign, a, b },
  });
  const call = (callee: string, ...args: readonly ExpressionSyntax[]): ExpressionSyntax => ({
    ...{ at, kind: 'call', callee: { at, name: callee }, args },
  });
  const make = (type: string, ...args: readonly ExpressionSyntax[]): ExpressionSyntax => {
    const known = GLSL_TYPES[type];
    return { at, kind: 'call', callee: { at, name: type, ...(known && { type: known }) }, args };
  };
  const input = (of: ShaderInput): ExpressionSyntax => ({ at, kind: 'input', input: of });
  const position = input('p.position');
  const size = input('p.size');
  /** Centre of the pixel, from the bottom left. */
  const here = make('vec2', member(position, 'x'), binary('-', member(size, 'y'), member(position, 'y')));
  return { input, number, binary, call, make, size, here };
};

/** A uniform or input of this name, and its type; undefined if there is none. */
export function globalNamed(
  name: string,
  at: SourceLocation,
): { readonly type: string; readonly value: ExpressionSyntax } | undefined {
  const { input, number, binary, make, size, here } = syntaxAt(at);
  const uv = binary('/', here, size);
  const globals: Readonly<Record<string, readonly [string, ExpressionSyntax]>> = {
    ...{ arg1: ['float', input('arg1')], arg2: ['float', input('arg2')] },
    ...{ arg3: ['float', input('arg3')], arg4: ['float', input('arg4')], alpha: ['float', input('arg1')] },
    ...{ time: ['float', input('time')], iTime: ['float', input('time')], iResolution: ['vec2', size] },
    ...{ view: ['mat4', input('p.view')], projection: ['mat4', input('p.projection')] },
    ...{ viewDirection: ['vec3', input('p.direction')], uv: ['vec2', uv], texCoord: ['vec2', uv] },
    ...{ TexCoord: ['vec2', uv], TexCoords: ['vec2', uv], vTexcoord: ['vec2', uv] },
    gl_FragCoord: ['vec4', make('vec4', here, number(0.5), number(1))],
  };
  const found = Object.hasOwn(globals, name) ? globals[name] : undefined;
  return found && { type: found[0], value: found[1] };
}

/** Names for messages. */
export const GLOBAL_EXAMPLES: readonly string[] = [
  ...['float arg1', 'float alpha', 'float time', 'vec2 iResolution', 'mat4 view', 'mat4 projection'],
  ...['vec3 viewDirection', 'vec2 uv'],
];

/** `texture(sampler, uv)`: the pixel in which uv lies. */
export function textureSyntax(channel: ShaderChannel, uv: ExpressionSyntax, at: SourceLocation): ExpressionSyntax {
  const { binary, call, size, here } = syntaxAt(at);
  return texel(channel, binary('-', call('floor', binary('*', uv, size)), call('floor', here)), at);
}

/** `texelFetch(sampler, pixel, 0)`. */
export function fetchSyntax(channel: ShaderChannel, pixel: ExpressionSyntax, at: SourceLocation): ExpressionSyntax {
  const { binary, call, make, here } = syntaxAt(at);
  return texel(channel, binary('-', make('vec2', pixel), call('floor', here)), at);
}

/** `textureSize(sampler, 0)`. */
export function sizeSyntax(at: SourceLocation): ExpressionSyntax {
  const { make, size } = syntaxAt(at);
  return make('ivec2', size);
}

/** `up`: offset with y up. */
function texel(channel: ShaderChannel, up: ExpressionSyntax, at: SourceLocation): ExpressionSyntax {
  const { number, binary, make } = syntaxAt(at);
  const minus: ExpressionSyntax = { at, kind: 'unary', sign: '-', of: number(1) };
  return { at, kind: 'texel', channel, offset: make('ivec2', binary('*', up, make('vec2', number(1), minus))) };
}
