import type { AttributeSpec, Layer, PrimSpec, PropertySpec, Value } from '../../src/formats/usd/index.ts';
import { indexedProperty } from './indexed.ts';
import { withSharedPoints } from './sharedPoints.ts';

/**
 * The same layer in fewer bytes, as authors of USD pack it: normals and uvs are indexed where they repeat, meshes
 * have each point once, samples that f32 hold are kept so, and those that are all the same are one value.
 */
export const packLayer = (layer: Layer): Layer => ({ ...layer, rootPrims: packed(layer.rootPrims) });

const packed = (prims: PrimSpec['children']): PrimSpec['children'] =>
  new Map([...prims].map(([name, prim]) => [name, packedPrim(prim)]));

function packedPrim(prim: PrimSpec): PrimSpec {
  const properties = [...withSharedPoints(asChangingSurface(prim.properties)).values()]
    .flatMap(indexedProperty)
    .map(packedSamples);
  return {
    ...prim,
    properties: new Map(properties.map((property) => [property.name, property])),
    children: packed(prim.children),
  };
}

/** Of a mesh whose topology changes, half of the bytes are normals and uvs: as a subdivision surface it has none, and readers make its normals. */
function asChangingSurface(properties: PrimSpec['properties']): PrimSpec['properties'] {
  const [faces, scheme] = ['faceVertexIndices', 'subdivisionScheme'].map((name) => properties.get(name));
  if (faces?.kind !== 'attribute' || !faces.timeSamples || scheme?.kind !== 'attribute') return properties;
  const kept = [...properties].filter(([name]) => name !== 'normals' && name !== 'primvars:st');
  return new Map([...kept, [scheme.name, { ...scheme, value: { type: 'token', data: 'loop' } }]]);
}

/** Types of transforms in f64, and those in f32. */
const NARROW: Readonly<Record<string, 'float3' | 'quatf'>> = { double3: 'float3', quatd: 'quatf' };

function packedSamples(property: PropertySpec): PropertySpec {
  if (property.kind !== 'attribute' || !property.timeSamples) return property;
  const narrow = NARROW[property.typeName];
  const { times, values } = property.timeSamples;
  const samples = values.map(numbersOf);
  if (!narrow || !samples.every((sample) => sample.every((x) => Math.fround(x) === x))) return property;
  const short = samples.map((sample): Value => ({ type: narrow, data: Float32Array.from(sample) }));
  const isConstant = samples.every((sample) => sample.every((x, k) => Object.is(x, samples[0][k])));
  const { timeSamples: _, ...rest } = property;
  const typed: AttributeSpec = { ...rest, typeName: narrow };
  return isConstant ? { ...typed, value: short[0] } : { ...typed, timeSamples: { times, values: short } };
}

const numbersOf = (value: Value): Float64Array => (value as { readonly data: Float64Array }).data;
