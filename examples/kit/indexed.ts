import type { AttributeSpec, PropertySpec } from '../../src/formats/usd/index.ts';

/** What the index of a vertex takes in a crate, about [bytes]. */
const INDEX_BYTES = 1.5;

/** Vertex attributes that repeat values, and the primvars that have each value once, with indices. `normals` itself cannot have them. */
const INDEXED: ReadonlyMap<string, { readonly size: number; readonly primvar: string }> = new Map([
  ['normals', { size: 3, primvar: 'primvars:normals' }],
  ['primvars:st', { size: 2, primvar: 'primvars:st' }],
]);

/** A property, or a table of its values and their places in it, where that is shorter. */
export function indexedProperty(property: PropertySpec): readonly PropertySpec[] {
  const as = INDEXED.get(property.name);
  if (!as || property.kind !== 'attribute' || !property.value || property.timeSamples) return [property];
  const { data } = property.value as { readonly data: Float32Array };
  const { table, indices } = uniqueTuples(data, as.size);
  if (table.byteLength + INDEX_BYTES * indices.length > data.byteLength) return [property];
  const values: AttributeSpec = {
    ...property,
    name: as.primvar,
    value: { type: as.size === 3 ? 'float3[]' : 'float2[]', data: table },
  };
  const places: AttributeSpec = {
    kind: 'attribute',
    name: `${as.primvar}:indices`,
    typeName: 'int[]',
    custom: false,
    uniform: false,
    metadata: new Map(),
    value: { type: 'int[]', data: indices },
  };
  return [values, places];
}

/** Each tuple once, in the order of their first use, and the place of each. */
function uniqueTuples(
  data: Float32Array,
  size: number,
): { readonly table: Float32Array; readonly indices: Int32Array } {
  const bits = new Uint32Array(data.buffer, data.byteOffset, data.length);
  const places = new Map<string, number>();
  const table: number[] = [];
  const indices = new Int32Array(data.length / size);
  for (let i = 0; i < indices.length; i++) {
    const [from, to] = [size * i, size * (i + 1)];
    const key = bits.subarray(from, to).join();
    const known = places.get(key);
    if (known === undefined) table.push(...data.subarray(from, to));
    indices[i] = known ?? places.size;
    places.set(key, indices[i]);
  }
  return { table: Float32Array.from(table), indices };
}
