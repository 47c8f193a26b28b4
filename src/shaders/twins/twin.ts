import type { Int, Vec4 } from '../types.ts';

/** A stratum of inputs: tolerances may depend on it, and it is named where a case fails. */
export interface Stratum {
  readonly name: string;
  /** Lorentz factor of the observer; 1 where there is none. */
  readonly gamma: number;
  /** Fastest speed of the source [c]. */
  readonly beta?: number;
  /** The observer is among the vertices. */
  readonly around?: boolean;
}

export interface TwinCase {
  readonly stratum: Stratum;
  /** 4 numbers per texel, in f64: the CPU takes them as they are, the GPU gets them rounded to f32, as an upload would. */
  readonly input: readonly number[];
}

/** How far the GPU may be from the CPU in one respect. */
export interface Check {
  /** With its unit: `direction [px]`. */
  readonly name: string;
  /** From both results (4 numbers per output) and the input. Not a number counts as infinitely wrong. */
  readonly error: (gpu: readonly number[], cpu: readonly number[], input: readonly number[]) => number;
  readonly tolerance: (stratum: Stratum) => number;
}

/** A shader function with its f64 equal, what both are given, and how equal they must be. */
export interface Twin {
  /** As it is exported from shaders/. */
  readonly name: string;
  /** Functions without an equal of their own, which are tested through this one. */
  readonly parts?: readonly string[];
  /** vec4 of input per case. */
  readonly texels: number;
  /** vec4 of output per case. */
  readonly outputs: number;
  readonly cases: (random: () => number) => readonly TwinCase[];
  readonly cpu: (input: readonly number[]) => readonly number[];
  /** Builds the outputs from the inputs, inside a shader function. */
  readonly gpu: (texel: (index: number | Int) => Vec4) => readonly Vec4[];
  readonly checks: readonly Check[];
}
