import {
  type AttributeSpec,
  type PrimSpec,
  type PropertySpec,
  type Value,
  writeCrate,
} from '../../src/formats/usd/index.ts';
import { indexedProperty } from './indexed.ts';

type Properties = PrimSpec['properties'];

/**
 * The properties of a mesh with each point once: normals and uvs, which made several vertices of it, are of the corners.
 * They are returned as they are where that is not shorter, or where it would be read as other vertices.
 */
export function withSharedPoints(properties: Properties): Properties {
  const attribute = (name: string): AttributeSpec | undefined => {
    const property = properties.get(name);
    return property?.kind === 'attribute' ? property : undefined;
  };
  const [points, faces] = [attribute('points'), attribute('faceVertexIndices')];
  const [normals, uvs] = [attribute('normals'), attribute('primvars:st')];
  if (!points || !faces?.value || !normals?.value || !uvs?.value) return properties;
  const corners = numbersOf<Int32Array>(faces.value);
  const samples = (points.timeSamples?.values ?? [points.value!]).map((value) => numbersOf<Float32Array>(value));
  const { kept, placeOf } = samePoints(samples);
  if (!areReadAlike(corners, placeOf, [normals.value, uvs.value])) return properties;
  const shared = samples.map((sample): Value => ({ type: 'float3[]', data: gathered(sample, kept, 3) }));
  const perCorner = (of: AttributeSpec, size: 2 | 3): AttributeSpec => ({
    ...of,
    value: { type: `float${size}[]`, data: gathered(numbersOf<Float32Array>(of.value!), corners, size) },
    metadata: new Map([['interpolation', { type: 'token', data: 'faceVarying' }]]),
  });
  const { timeSamples } = points;
  const changed: readonly PropertySpec[] = [
    { ...points, ...(timeSamples ? { timeSamples: { ...timeSamples, values: shared } } : { value: shared[0] }) },
    { ...faces, value: { type: 'int[]', data: corners.map((vertex) => placeOf[vertex]) } },
    perCorner(normals, 3),
    perCorner(uvs, 2),
  ];
  const merged = new Map([...properties, ...changed.map((property) => [property.name, property] as const)]);
  return packedSize(merged) < packedSize(properties) ? merged : properties;
}

/** What a mesh takes in a crate. */
function packedSize(properties: Properties): number {
  const nothing = { metadata: new Map(), children: new Map(), variantSets: new Map() };
  const packed = new Map(
    [...properties.values()].flatMap(indexedProperty).map((property) => [property.name, property]),
  );
  const prim: PrimSpec = { path: '/A', name: 'A', specifier: 'def', typeName: 'Mesh', properties: packed, ...nothing };
  return writeCrate({ name: '', metadata: new Map(), rootPrims: new Map([['A', prim]]) }).length;
}

/** Readers make a vertex of each corner that differs from those before at its point: the same vertices, in the same order. */
function areReadAlike(corners: Int32Array, placeOf: Int32Array, values: readonly Value[]): boolean {
  const [normals, uvs] = values.map((value) => numbersOf<Float32Array>(value));
  const seen = new Set<string>();
  let next = 0;
  for (const vertex of corners) {
    if (vertex > next) return false;
    if (vertex < next) continue;
    next++;
    const normal = normals.subarray(3 * vertex, 3 * vertex + 3).join();
    seen.add(`${placeOf[vertex]};${normal};${uvs.subarray(2 * vertex, 2 * vertex + 2).join()}`);
  }
  return next === placeOf.length && seen.size === next;
}

const numbersOf = <T>(value: Value): T => (value as unknown as { readonly data: T }).data;

/** One vertex of each place, and the place of each vertex. */
function samePoints(samples: readonly Float32Array[]): { readonly kept: number[]; readonly placeOf: Int32Array } {
  const kept: number[] = [];
  const places = new Map<string, number>();
  const placeOf = new Int32Array(samples[0].length / 3);
  for (let vertex = 0; vertex < placeOf.length; vertex++) {
    const key = samples.map((sample) => sample.subarray(3 * vertex, 3 * vertex + 3).join()).join(';');
    const known = places.get(key);
    if (known === undefined) kept.push(vertex);
    placeOf[vertex] = known ?? places.size;
    places.set(key, placeOf[vertex]);
  }
  return { kept, placeOf };
}

const gathered = (values: Float32Array, from: ArrayLike<number>, size: number): Float32Array =>
  Float32Array.from({ length: size * from.length }, (_, i) => values[size * from[Math.floor(i / size)] + (i % size)]);
