import { type Message, msg } from '../../../messages/message.ts';
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
      readonly shape: TupleShape;
    };

/** The parts of a tuple or matrix, and where they are, for messages: a file has many tuples of few shapes. */
export interface TupleShape {
  readonly parts: number;
  /** Shape of a part; absent: parts are numbers. */
  readonly part?: TupleShape;
  /** Number of numbers. */
  readonly size: number;
  readonly before: Message;
  readonly between: Message;
  readonly after: Message;
}

function tupleShape(parts: number, part?: TupleShape): TupleShape {
  return {
    parts,
    ...(part && { part }),
    size: parts * (part?.size ?? 1),
    before: msg`before a value with ${part ? `${parts} × ${part.parts}` : parts} numbers`,
    between: msg`between the ${parts} parts of a value`,
    after: msg`after the ${parts} parts of a value`,
  };
}

export type ScalarKind = 'uchar' | 'int' | 'uint' | 'half' | 'float' | 'double';

const rolesOf = {
  2: ['texCoord'],
  3: ['point', 'vector', 'normal', 'color', 'texCoord'],
  4: ['color'],
} as const;

/** Type name without `[]` → storage. Roles and the names of former versions are aliases (OpenUSD, Sdf_ValueTypeNames). */
export const valueTypes: ReadonlyMap<string, ValueType> = new Map(allTypes());

function* allTypes(): Generator<[string, ValueType]> {
  yield ['bool', { kind: 'bool', storage: 'bool' }];
  for (const scalar of ['uchar', 'int', 'uint', 'half', 'float', 'double'] as const)
    yield [scalar, { kind: 'number', storage: scalar, scalar }];
  for (const index of ['PointIndex', 'EdgeIndex', 'FaceIndex'])
    yield [index, { kind: 'number', storage: 'int', scalar: 'int' }];
  yield ['timecode', { kind: 'number', storage: 'timecode', scalar: 'double' }];
  for (const storage of ['int64', 'uint64'] as const) yield [storage, { kind: 'long', storage }];
  for (const storage of ['string', 'token', 'asset', 'pathExpression'] as const)
    yield [storage, { kind: 'text', storage }];
  yield* vectors();
  for (const n of [2, 3, 4] as const) {
    const shape = tupleShape(n, tupleShape(n));
    const names = [`matrix${n}d`, `Matrix${n}d`, ...(n === 4 ? ['frame4d', 'Frame', 'Transform'] : [])];
    for (const name of names) yield [name, { kind: 'tuple', storage: `matrix${n}d`, scalar: 'double', shape }];
  }
  for (const [letter, scalar] of [
    ['h', 'half'],
    ['f', 'float'],
    ['d', 'double'],
  ] as const)
    for (const name of ['quat', 'Quat'])
      yield [`${name}${letter}`, { kind: 'tuple', storage: `quat${letter}`, scalar, shape: tupleShape(4) }];
}

function* vectors(): Generator<[string, ValueType]> {
  for (const n of [2, 3, 4] as const) {
    for (const scalar of ['int', 'half', 'float', 'double'] as const) {
      const type: ValueType = { kind: 'tuple', storage: `${scalar}${n}`, scalar, shape: tupleShape(n) };
      yield [`${scalar}${n}`, type];
      yield [`Vec${n}${scalar[0]}`, type];
      if (scalar !== 'int') for (const role of rolesOf[n]) yield [`${role}${n}${scalar[0]}`, type];
    }
  }
  for (const [suffix, scalar] of [
    ['', 'double'],
    ['Float', 'float'],
  ] as const)
    for (const role of ['Point', 'Normal', 'Vector', 'Color'])
      yield [`${role}${suffix}`, { kind: 'tuple', storage: `${scalar}3`, scalar, shape: tupleShape(3) }];
}
