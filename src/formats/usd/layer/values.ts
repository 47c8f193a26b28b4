import type { TupleType, Value } from './layer.ts';

/** Values of a layer, by their storage types. */
export const bool = (data: boolean): Value => ({ type: 'bool', data });
export const int = (data: number): Value => ({ type: 'int', data });
export const double = (data: number): Value => ({ type: 'double', data });
export const float = (x: number): Value => ({ type: 'float', data: Math.fround(x) });
export const string = (data: string): Value => ({ type: 'string', data });
export const token = (data: string): Value => ({ type: 'token', data });
export const tokens = (data: readonly string[]): Value => ({ type: 'token[]', data });
export const asset = (data: string): Value => ({ type: 'asset', data });
export const matrices = (data: Float64Array): Value => ({ type: 'matrix4d[]', data });
export const floats = (data: Float32Array): Value => ({ type: 'float[]', data });
export const halfTuples = (data: Float32Array): Value => ({ type: 'half3[]', data });
/** Quaternions x y z w. */
export const quaternions = (data: Float32Array): Value => ({ type: 'quatf[]', data });
export const ints = (data: Int32Array): Value => ({ type: 'int[]', data });

/** A vector, or a quaternion x y z w. */
export const tuple = (type: TupleType, numbers: readonly number[]): Value =>
  /d$|^double/.test(type) ? { type, data: Float64Array.from(numbers) } : { type, data: Float32Array.from(numbers) };

/** Vectors of f32, `scale` times as long; multiplied before they are rounded. */
export const floatTuples = (type: 'float2' | 'float3', data: Float32Array, scale = 1): Value => ({
  type: `${type}[]`,
  data: scale === 1 ? data : Float32Array.from(data, (x) => x * scale),
});

/** A value that is made anew each time it is asked for: all samples of a large mesh need not be in memory. */
export class LazyTuples {
  readonly type = 'float3[]';
  private readonly make: () => Float32Array;

  constructor(make: () => Float32Array) {
    this.make = make;
  }

  get data(): Float32Array {
    return this.make();
  }
}
