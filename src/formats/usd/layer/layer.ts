/** The layer model: the contents of one USD file before composition and schemas. Filled by the text and the crate reader. */
export interface Layer {
  /** The file, for messages. */
  readonly name: string;
  /** Layer metadata by key; `subLayers` and `customLayerData` are among them. */
  readonly metadata: ReadonlyMap<string, MetadataValue>;
  readonly rootPrims: ReadonlyMap<string, PrimSpec>;
  /** `reorder rootPrims`. */
  rootOrder?: readonly string[];
}

/** Shared by all prims without entries: a scene of a million prims would have four million empty maps. */
export const EMPTY_MAP: ReadonlyMap<string, never> = new Map<string, never>();

/** Adds an entry to `map`, or to a new map if it is the shared empty one. */
export function withEntry<T>(map: ReadonlyMap<string, T>, key: string, value: T): ReadonlyMap<string, T> {
  const own = map === EMPTY_MAP ? new Map<string, T>() : (map as Map<string, T>);
  return own.set(key, value);
}

export type Specifier = 'def' | 'over' | 'class';

export interface PrimSpec {
  /** Absolute: `/World/Cube`; inside a variant `/World{shade=red}Cube`. */
  readonly path: string;
  readonly name: string;
  readonly specifier: Specifier;
  /** Empty where none is written. */
  readonly typeName: string;
  metadata: ReadonlyMap<string, MetadataValue>;
  properties: ReadonlyMap<string, PropertySpec>;
  children: ReadonlyMap<string, PrimSpec>;
  /** Variant set → variant → its opinions. Sets without variants are absent. */
  variantSets: ReadonlyMap<string, ReadonlyMap<string, PrimSpec>>;
  /** Content key of a composed prim: prims with equal keys differ only in placement (compose/prim/contentKey.ts). */
  content?: string;
  childOrder?: readonly string[];
  propertyOrder?: readonly string[];
}

export type PropertySpec = AttributeSpec | RelationshipSpec;

export interface AttributeSpec {
  readonly kind: 'attribute';
  readonly name: string;
  /** As written, with its role: `color3f[]`. */
  readonly typeName: string;
  custom: boolean;
  uniform: boolean;
  /** Absent: no default. `blocked`: `None`, which blocks weaker opinions. */
  value?: Value;
  timeSamples?: TimeSamples;
  connections?: ListOp<string>;
  spline?: Spline;
  metadata: ReadonlyMap<string, MetadataValue>;
}

export interface RelationshipSpec {
  readonly kind: 'relationship';
  readonly name: string;
  custom: boolean;
  /** `rel` is uniform unless `varying` is written. */
  uniform: boolean;
  targets?: ListOp<string>;
  metadata: ReadonlyMap<string, MetadataValue>;
}

/** Samples at rising time codes; a sample can be `blocked`. */
export interface TimeSamples {
  readonly times: Float64Array;
  readonly values: readonly Value[];
}

/** An animation curve: knots, interpolation and extrapolation (OpenUSD, Ts). */
export interface Spline {
  readonly curve: 'bezier' | 'hermite';
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly loop?: SplineLoop;
  /** At rising time codes. */
  readonly knots: readonly SplineKnot[];
}

export type Extrapolation =
  | { readonly kind: 'none' | 'held' | 'linear' | 'repeat' | 'reset' | 'oscillate' }
  | { readonly kind: 'sloped'; readonly slope: number };

/** The interval from `start` to `end` is repeated `before` and `after` it, each time `offset` higher. */
export interface SplineLoop {
  readonly start: number;
  readonly end: number;
  readonly before: number;
  readonly after: number;
  readonly offset: number;
}

export interface SplineKnot {
  readonly time: number;
  readonly value: number;
  /** Left limit at the knot, where the curve jumps. */
  readonly preValue?: number;
  /** Of the segment to the next knot. `none`: the attribute has no value there. */
  readonly interpolation: 'none' | 'held' | 'linear' | 'curve';
  readonly pre: Tangent;
  readonly post: Tangent;
  readonly customData?: Dictionary;
}

/** `width` [time codes] is 0 in Hermite curves, which have none; `algorithm` is what width and slope were made by. */
export interface Tangent {
  readonly width: number;
  readonly slope: number;
  readonly algorithm: 'none' | 'custom' | 'autoEase';
}

export type NumberArray = Float64Array | Float32Array | Int32Array | Uint32Array | Uint8Array;

/**
 * A value of one storage type. A role is of the property, not of the value: `color3f` is stored as `float3`.
 * Vectors, matrices (row by row, as written) and arrays of them are flat. Quaternions are x y z w, though the text has
 * w first. Halves are held as f32, which holds them exactly. `unregistered` is the text as written.
 * After composition, `anchor` is the layer that an asset's path is relative to.
 */
export type Value =
  | { readonly type: 'blocked' }
  | { readonly type: 'animationBlock' }
  | { readonly type: 'bool'; readonly data: boolean }
  | { readonly type: NumberType; readonly data: number }
  | { readonly type: 'int64' | 'uint64'; readonly data: bigint }
  | { readonly type: Exclude<TextType, 'asset'> | 'unregistered'; readonly data: string }
  | { readonly type: 'asset'; readonly data: string; readonly anchor?: string }
  | { readonly type: TupleType; readonly data: NumberArray }
  | { readonly type: ArrayOf<NumberType | TupleType | 'bool'>; readonly data: NumberArray }
  | { readonly type: 'int64[]'; readonly data: BigInt64Array }
  | { readonly type: 'uint64[]'; readonly data: BigUint64Array }
  | { readonly type: ArrayOf<Exclude<TextType, 'asset'>>; readonly data: readonly string[] }
  | { readonly type: 'asset[]'; readonly data: readonly string[]; readonly anchor?: string }
  | { readonly type: 'dictionary'; readonly data: Dictionary };

export type Dictionary = ReadonlyMap<string, Value>;
type ArrayOf<T extends string> = `${T}[]`;
export type NumberType = 'uchar' | 'int' | 'uint' | 'half' | 'float' | 'double' | 'timecode';
export type TextType = 'string' | 'token' | 'asset' | 'pathExpression';
export type TupleType =
  | `${'int' | 'half' | 'float' | 'double'}${2 | 3 | 4}`
  | `matrix${2 | 3 | 4}d`
  | `quat${'h' | 'f' | 'd'}`;

/** How one layer's opinion on a list is combined with weaker ones. */
export interface ListOp<T> {
  /** Set where the list is written without a qualifier: it replaces weaker lists. `None` is an empty one. */
  explicit?: readonly T[];
  prepended?: readonly T[];
  appended?: readonly T[];
  deleted?: readonly T[];
  added?: readonly T[];
  ordered?: readonly T[];
}

/** The target of a reference or payload. An empty `asset` means this layer, an empty `path` the default prim. */
export interface ReferenceSpec {
  readonly asset: string;
  readonly path: string;
  readonly offset: number;
  readonly scale: number;
  readonly customData?: Dictionary;
}

export type MetadataValue =
  | Value
  | { readonly type: 'texts'; readonly op: ListOp<string> }
  | { readonly type: 'integers'; readonly op: ListOp<bigint> }
  | { readonly type: 'unregistereds'; readonly op: ListOp<Value> }
  | { readonly type: 'paths'; readonly op: ListOp<string> }
  | { readonly type: 'arcs'; readonly op: ListOp<ReferenceSpec> }
  | { readonly type: 'subLayers'; readonly data: readonly ReferenceSpec[] }
  | { readonly type: 'relocates'; readonly data: readonly (readonly [from: string, to: string])[] }
  | { readonly type: 'texts-by-name'; readonly data: ReadonlyMap<string, string> };
