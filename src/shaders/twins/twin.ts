import type { Int, Vec4 } from '../types.ts';

/** A stratum of inputs: tolerances may depend on it, and failure messages name it. */
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
  /** 4 numbers per texel, in f64: the CPU uses them as they are, the GPU rounded to f32. */
  readonly input: readonly number[];
}

/** One comparison of GPU and CPU results with its tolerance. */
export interface Check {
  /** Including the unit, e.g. `direction [px]`. */
  readonly name: string;
  /** The error, from both results (4 numbers per output) and the input. NaN counts as infinite. */
  readonly error: (gpu: readonly number[], cpu: readonly number[], input: readonly number[]) => number;
  readonly tolerance: (stratum: Stratum) => number;
}

/** A shader function with its f64 counterpart, their inputs, and the tolerances. */
export interface Twin {
  /** The function's name as exported from shaders/. */
  readonly name: string;
  /** Functions without a twin of their own that are tested through this one. */
  readonly parts?: readonly string[];
  /** vec4 of input per case. */
  readonly texels: number;
  /** vec4 of output per case. */
  readonly outputs: number;
  readonly cases: (random: () => number) => readonly TwinCase[];
  readonly cpu: (input: readonly number[]) => readonly number[];
  /** Builds the output nodes from the input texels, inside a shader function. */
  readonly gpu: (texel: (index: number | Int) => Vec4) => readonly Vec4[];
  readonly checks: readonly Check[];
}
