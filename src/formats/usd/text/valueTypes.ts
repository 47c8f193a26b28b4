import type { NumberType, TextType, TupleType } from '../layer/layer.ts';

/** Text syntax and storage of a type. */
export type ValueType =
  | { readonly kind: 'bool'; readonly storage: 'bool' }
  | { readonly kind: 'number'; readonly storage: NumberType; readonly scalar: ScalarKind }
  | { readonly kind: 'long'; readonly storage: 'int64' | 'uint64' }
  | { readonly kind: 'text'; readonly storage: TextType }
  | {
      readonly kind: 'tuple';
      readonly storage: TupleType;
      readonly scalar: ScalarKind;
      readonly shape: readonly number[];
    };

export type ScalarKind = 'uchar' | 'int' | 'uint' | 'half' | 'float' | 'double';

const rolesOf = {
  2: ['texCoord'],
  3: ['point', 'vector', 'normal', 'color', 'texCoord'],
  4: ['color'],
} as const;

/** Type name without `[]` → storage. Roles are aliases (OpenUSD, Sdf_ValueTypeNames). */
export const valueTypes: ReadonlyMap<string, ValueType> = new Map(allTypes());

function* allTypes(): Generator<[string, ValueType]> {
  yield ['bool', { kind: 'bool', storage: 'bool' }];
  for (const scalar of ['uchar', 'int', 'uint', 'half', 'float', 'double'] as const)
    yield [scalar, { kind: 'number', storage: scalar, scalar }];
  yield ['timecode', { kind: 'number', storage: 'timecode', scalar: 'double' }];
  for (const storage of ['int64', 'uint64'] as const) yield [storage, { kind: 'long', storage }];
  for (const storage of ['string', 'token', 'asset', 'pathExpression'] as const)
    yield [storage, { kind: 'text', storage }];
  yield* vectors();
  for (const n of [2, 3, 4] as const)
    yield [`matrix${n}d`, { kind: 'tuple', storage: `matrix${n}d`, scalar: 'double', shape: [n, n] }];
  yield ['frame4d', { kind: 'tuple', storage: 'matrix4d', scalar: 'double', shape: [4, 4] }];
  yield ['quath', { kind: 'tuple', storage: 'quath', scalar: 'half', shape: [4] }];
  yield ['quatf', { kind: 'tuple', storage: 'quatf', scalar: 'float', shape: [4] }];
  yield ['quatd', { kind: 'tuple', storage: 'quatd', scalar: 'double', shape: [4] }];
}

function* vectors(): Generator<[string, ValueType]> {
  for (const n of [2, 3, 4] as const) {
    for (const scalar of ['int', 'half', 'float', 'double'] as const) {
      const type: ValueType = { kind: 'tuple', storage: `${scalar}${n}`, scalar, shape: [n] };
      yield [`${scalar}${n}`, type];
      if (scalar !== 'int') for (const role of rolesOf[n]) yield [`${role}${n}${scalar[0]}`, type];
    }
  }
}
