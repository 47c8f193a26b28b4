import { type Accessor, MathUtils } from '@gltf-transform/core';

/** All numbers of an accessor, normalised integers as fractions; float data are shared. */
export function floatsOf(accessor: Accessor): Float32Array {
  const array = accessor.getArray();
  if (!array) return new Float32Array(0);
  if (array instanceof Float32Array) return array;
  const type = accessor.getComponentType();
  if (!accessor.getNormalized()) return Float32Array.from(array);
  return Float32Array.from(array, (value: number) => MathUtils.decodeNormalizedInt(value, type));
}
