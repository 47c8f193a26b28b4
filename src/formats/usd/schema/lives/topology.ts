import { attributeOf, sampleTimes } from '../../layer/attributes.ts';
import type { AttributeSpec, PrimSpec, Value } from '../../layer/layer.ts';
import { countOf } from '../../layer/storedArray.ts';

/** Whether the topology of a mesh may change with time. */
export const isTopologySampled = (prim: PrimSpec): boolean =>
  topologyArrays(prim).some((attribute) => sampleTimes(attribute).length > 0) ||
  !haveOneCount(attributeOf(prim, 'points'));

/** The attributes by which faces and their materials are found. */
export function topologyArrays(prim: PrimSpec): readonly (AttributeSpec | undefined)[] {
  const own = ['faceVertexCounts', 'faceVertexIndices', 'holeIndices'].map((name) => attributeOf(prim, name));
  const subsets = [...prim.children.values()].filter(({ typeName }) => typeName === 'GeomSubset');
  return [...own, ...subsets.map((subset) => attributeOf(subset, 'indices'))];
}

export const countIn = (value: Value | undefined): number => (value && countOf(value)) ?? 0;

export const haveOneCount = (attribute: AttributeSpec | undefined): boolean => {
  const [first, ...others] = attribute?.timeSamples?.values ?? [];
  return first === undefined || others.every((value) => countIn(value) === countIn(first));
};
