import type { NumberType, TextType, TupleType } from '../../layer/layer.ts';

export type CrateScalar = 'bool' | 'uchar' | 'int' | 'uint' | 'half' | 'float' | 'double';

/** A type that can have arrays. */
export type ArrayType =
  | { readonly kind: 'bool'; readonly storage: 'bool' }
  | { readonly kind: 'number'; readonly storage: NumberType; readonly scalar: CrateScalar }
  | { readonly kind: 'long'; readonly storage: 'int64' | 'uint64' }
  | { readonly kind: 'text'; readonly storage: TextType }
  | { readonly kind: 'tuple'; readonly storage: TupleType; readonly scalar: CrateScalar; readonly size: number };

/** Numbers of types in a crate (OpenUSD, sdf/crateDataTypes.h) whose values can stand in arrays. */
export const ARRAY_TYPES: ReadonlyMap<number, ArrayType> = new Map(allArrayTypes());

function* allArrayTypes(): Generator<[number, ArrayType]> {
  yield [1, { kind: 'bool', storage: 'bool' }];
  yield [2, { kind: 'number', storage: 'uchar', scalar: 'uchar' }];
  yield [3, { kind: 'number', storage: 'int', scalar: 'int' }];
  yield [4, { kind: 'number', storage: 'uint', scalar: 'uint' }];
  yield [5, { kind: 'long', storage: 'int64' }];
  yield [6, { kind: 'long', storage: 'uint64' }];
  yield [7, { kind: 'number', storage: 'half', scalar: 'half' }];
  yield [8, { kind: 'number', storage: 'float', scalar: 'float' }];
  yield [9, { kind: 'number', storage: 'double', scalar: 'double' }];
  yield [10, { kind: 'text', storage: 'string' }];
  yield [11, { kind: 'text', storage: 'token' }];
  yield [12, { kind: 'text', storage: 'asset' }];
  yield [13, { kind: 'tuple', storage: 'matrix2d', scalar: 'double', size: 4 }];
  yield [14, { kind: 'tuple', storage: 'matrix3d', scalar: 'double', size: 9 }];
  yield [15, { kind: 'tuple', storage: 'matrix4d', scalar: 'double', size: 16 }];
  yield [16, { kind: 'tuple', storage: 'quatd', scalar: 'double', size: 4 }];
  yield [17, { kind: 'tuple', storage: 'quatf', scalar: 'float', size: 4 }];
  yield [18, { kind: 'tuple', storage: 'quath', scalar: 'half', size: 4 }];
  const scalars = ['double', 'float', 'half', 'int'] as const;
  for (const size of [2, 3, 4] as const)
    for (const [i, scalar] of scalars.entries())
      yield [4 * size + 11 + i, { kind: 'tuple', storage: `${scalar}${size}`, scalar, size }];
  yield [56, { kind: 'number', storage: 'timecode', scalar: 'double' }];
  yield [57, { kind: 'text', storage: 'pathExpression' }];
}

/** Type codes of the other types, by name. */
export const NON_ARRAY_TYPES = {
  dictionary: 31,
  tokenListOp: 32,
  stringListOp: 33,
  pathListOp: 34,
  referenceListOp: 35,
  intListOp: 36,
  int64ListOp: 37,
  uintListOp: 38,
  uint64ListOp: 39,
  pathVector: 40,
  tokenVector: 41,
  specifier: 42,
  permission: 43,
  variability: 44,
  variantSelections: 45,
  timeSamples: 46,
  payload: 47,
  doubleVector: 48,
  offsetVector: 49,
  stringVector: 50,
  blocked: 51,
  value: 52,
  unregistered: 53,
  unregisteredListOp: 54,
  payloadListOp: 55,
  relocates: 58,
  spline: 59,
  animationBlock: 60,
} as const;
