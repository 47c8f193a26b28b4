import {
  type AttributeSpec,
  EMPTY_MAP,
  type PrimSpec,
  type PropertySpec,
  type RelationshipSpec,
  type Value,
} from './layer.ts';

export type Properties = readonly PropertySpec[];

/** An attribute; `said` is what else is written of it. */
export const attribute = (
  typeName: string,
  name: string,
  value?: Value,
  said: Partial<Omit<AttributeSpec, 'kind' | 'name' | 'typeName'>> = {},
): AttributeSpec => ({
  kind: 'attribute',
  name,
  typeName,
  custom: false,
  uniform: false,
  metadata: EMPTY_MAP,
  ...(value && { value }),
  ...said,
});

export const uniform = (typeName: string, name: string, value: Value): AttributeSpec =>
  attribute(typeName, name, value, { uniform: true });

/** An attribute that no schema declares. */
export const custom = (typeName: string, name: string, value: Value): AttributeSpec =>
  attribute(typeName, name, value, { custom: true });

/** An input that takes what comes out elsewhere. */
export const connected = (typeName: string, name: string, from: string): AttributeSpec =>
  attribute(typeName, name, undefined, { connections: { explicit: [from] } });

/** An attribute with values at time codes. */
export const sampled = (
  typeName: string,
  name: string,
  times: Float64Array,
  value: (i: number) => Value,
  metadata: PrimSpec['metadata'] = EMPTY_MAP,
): AttributeSpec =>
  attribute(typeName, name, undefined, {
    timeSamples: { times, values: Array.from(times, (_, i) => value(i)) },
    metadata,
  });

export const relationship = (name: string, ...explicit: readonly string[]): RelationshipSpec => ({
  kind: 'relationship',
  name,
  custom: false,
  uniform: true,
  targets: { explicit },
  metadata: EMPTY_MAP,
});

/** `interpolation = "vertex"` */
export const PER_VERTEX: PrimSpec['metadata'] = new Map([['interpolation', { type: 'token', data: 'vertex' }]]);

/** `interpolation = "vertex"`, with `elementSize` values for each vertex. */
export const perVertexOf = (elementSize: number): PrimSpec['metadata'] =>
  new Map<string, Value>([
    ['elementSize', { type: 'int', data: elementSize }],
    ['interpolation', { type: 'token', data: 'vertex' }],
  ]);

/** `prepend apiSchemas = ["…"]` */
export const schemas = (...prepended: readonly string[]): PrimSpec['metadata'] =>
  new Map([['apiSchemas', { type: 'texts', op: { prepended } }]]);

/** What a prim is, apart from its children that have prims of their own. */
export interface PrimContent {
  readonly type: string;
  readonly metadata?: PrimSpec['metadata'];
  readonly properties: Properties;
  /** Prims written whole, such as subsets and shaders, by their names. */
  readonly inner?: ReadonlyMap<string, PrimContent>;
}

/** A defined prim at a path. */
export function primSpec(path: string, content: PrimContent, children: PrimSpec['children'] = EMPTY_MAP): PrimSpec {
  const { type, metadata = EMPTY_MAP, properties, inner = EMPTY_MAP } = content;
  const own = [...inner].map(([name, prim]) => [name, primSpec(`${path}/${name}`, prim)] as const);
  return {
    path,
    name: path.slice(path.lastIndexOf('/') + 1),
    specifier: 'def',
    typeName: type,
    metadata,
    properties: new Map(properties.map((property) => [property.name, property])),
    children: new Map([...own, ...children]),
    variantSets: EMPTY_MAP,
  };
}
