import type { ShaderType } from './types.ts';

/** Channels that a text can sample, at an offset from the current pixel in whole pixels, y down. */
export const SHADER_CHANNELS = {
  /** Linear colour and opacity. */
  image: 4,
  /** The same of a second image, if the node has one. */
  image2: 4,
  /** 1 on surfaces, 0 on the sky. */
  there: 1,
  /** Apparent distance |Δx′| [m]. */
  depth: 1,
  /** Unit, in the surface's rest frame. */
  normal: 3,
  /** Base colour, linear sRGB. */
  albedo: 3,
  roughness: 1,
  metallic: 1,
  /** (metallic, roughness) */
  metallicRoughness: 2,
  /** Observer → apparent position, observer's frame on world axes carried by the boost [m]. */
  apparent: 3,
  /** z/w of the apparent position under `p.projection`: 0 … 1 from 0.2 m on. */
  clipDepth: 1,
  /** Observer → event, world frame [m]. */
  event: 3,
  /** World time of the event after the observer's [s]. */
  emissionTime: 1,
  /** Of the surface, world frame, units of c. */
  velocity: 3,
  /** D = ν_observed/ν_emitted. */
  doppler: 1,
  /** Place of the object in the scene plus one. */
  object: 1,
} as const;
export type ShaderChannel = keyof typeof SHADER_CHANNELS;

/** Inputs besides the channels, by name, and their number of components. */
export const SHADER_INPUTS = {
  arg1: 1,
  arg2: 1,
  arg3: 1,
  arg4: 1,
  /** World time of the observer [s]. */
  time: 1,
  /** Of the pixel's centre, from the top left corner [px]. */
  'p.position': 2,
  /** The same over the picture's size. */
  'p.uv': 2,
  /** Of the picture [px]. */
  'p.size': 2,
  /** View direction of the pixel: unit, world frame. */
  'p.direction': 3,
  /** Apparent positions → camera axes. */
  'p.view': 16,
  /** Camera axes → clip space of OpenGL, without a far plane. */
  'p.projection': 16,
} as const;
export type ShaderInput = keyof typeof SHADER_INPUTS;
/** Near plane of `p.projection` [m]. */
export const PROJECTION_NEAR = 0.1;

/** Builtin functions. All are component-wise except `VECTOR_FUNCTIONS`; all arguments have one shape. */
export const FLOAT_FUNCTIONS = {
  ...{ sin: 1, cos: 1, tan: 1, asin: 1, acos: 1, atan: 1, sinh: 1, cosh: 1, tanh: 1, exp: 1, exp2: 1, log: 1, log2: 1 },
  ...{ sqrt: 1, inverseSqrt: 1, floor: 1, ceil: 1, round: 1, trunc: 1, fract: 1, radians: 1, degrees: 1, saturate: 1 },
  ...{ pow: 2, atan2: 2, step: 2, mix: 3, smoothstep: 3 },
} as const;
export const NUMBER_FUNCTIONS = { abs: 1, sign: 1, min: 2, max: 2, clamp: 3 } as const;
/** On whole vectors. */
export const VECTOR_FUNCTIONS = { dot: 2, length: 1, distance: 2, normalize: 1, cross: 2, reflect: 2 } as const;
/** Of GLSL only. `mod` differs from `%` for negative numbers. */
export const GLSL_FUNCTIONS = { mod: 2, inverse: 1, transpose: 1 } as const;

export type ShaderOperation =
  | keyof typeof FLOAT_FUNCTIONS
  | keyof typeof NUMBER_FUNCTIONS
  | keyof typeof VECTOR_FUNCTIONS
  | keyof typeof GLSL_FUNCTIONS
  | 'select'
  | 'negate'
  | 'not'
  | ShaderBinaryOperation
  /** Matrix × matrix, matrix × vector, vector × matrix. */
  | 'product';
export type ShaderBinaryOperation =
  | 'add'
  | 'sub'
  | 'mul'
  | 'div'
  | 'rem'
  | 'and'
  | 'or'
  | 'eq'
  | 'ne'
  | 'lt'
  | 'le'
  | 'gt'
  | 'ge';

/** A type-checked program: variables are resolved to indices, types match, and every loop count is known. Plain data. */
export interface ShaderProgram {
  readonly functions: readonly ShaderFunction[];
  /** Index of `effect`. */
  readonly effect: number;
  /** The channels that it samples, each once. */
  readonly reads: readonly ShaderChannel[];
}

export interface ShaderFunction {
  readonly name: string;
  /** Types of its variables, parameters first. */
  readonly locals: readonly ShaderType[];
  readonly params: number;
  readonly result: ShaderType;
  readonly body: readonly ShaderStatement[];
}

export type ShaderExpression = { readonly type: ShaderType } & (
  | { readonly op: 'constant'; readonly numbers: readonly number[] }
  | { readonly op: 'local'; readonly local: number }
  | { readonly op: 'input'; readonly input: ShaderInput }
  | { readonly op: 'look'; readonly channel: ShaderChannel; readonly offset: ShaderExpression }
  /** Components of a vector, or a column of a matrix. */
  | { readonly op: 'parts'; readonly of: ShaderExpression; readonly parts: readonly number[] }
  | { readonly op: 'column'; readonly of: ShaderExpression; readonly column: number }
  /** From consecutive components; a single scalar is broadcast. */
  | { readonly op: 'build'; readonly parts: readonly ShaderExpression[] }
  | { readonly op: 'convert'; readonly of: ShaderExpression }
  /** A matrix from a scalar on its diagonal, or from a matrix of another size, filled up by the identity. */
  | { readonly op: 'reshape'; readonly of: ShaderExpression }
  | { readonly op: 'apply'; readonly f: ShaderOperation; readonly args: readonly ShaderExpression[] }
  | { readonly op: 'call'; readonly f: number; readonly args: readonly ShaderExpression[] }
);

export type ShaderStatement =
  | { readonly op: 'set'; readonly local: number; readonly part: number | undefined; readonly value: ShaderExpression }
  | {
      readonly op: 'if';
      readonly test: ShaderExpression;
      readonly yes: readonly ShaderStatement[];
      readonly no: readonly ShaderStatement[];
    }
  /** The variable is `first`, `first + by` …, `count` times. */
  | {
      readonly op: 'for';
      readonly local: number;
      readonly first: number;
      readonly by: number;
      readonly count: number;
      readonly body: readonly ShaderStatement[];
    }
  | { readonly op: 'return'; readonly value: ShaderExpression }
  | { readonly op: 'break' | 'continue' };
