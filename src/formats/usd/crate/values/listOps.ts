import { msg } from '../../../../messages/message.ts';
import type { ListOp, ReferenceSpec } from '../../layer/layer.ts';
import type { Cursor } from '../structure/crateSource.ts';
import { NON_ARRAY_TYPES } from './crateTypes.ts';
import type { FieldValue, ValueDecoder } from './fieldValue.ts';
import type { ValueRep } from './valueRep.ts';

const A_TOKEN = msg`a token`;
const A_STRING = msg`a string`;
const A_PATH = msg`a path`;
const AN_INTEGER = msg`an integer`;
const A_NUMBER = msg`a number`;
const AN_ASSET = msg`an asset`;
const AN_OFFSET = msg`an offset`;
const A_SCALE = msg`a scale`;

/** Memory of a list item [bytes]. */
const ITEM_BYTES = 32;

/** Bits of a list op's first byte, in the order in which its lists follow. The lowest says that it is explicit. */
export const LIST_BITS: readonly (readonly [bit: number, list: keyof ListOp<unknown>])[] = [
  [2, 'explicit'],
  [4, 'added'],
  [32, 'prepended'],
  [64, 'appended'],
  [8, 'deleted'],
  [16, 'ordered'],
];

type ListItem<T> = { readonly bytes: number; read(reader: ValueDecoder, cursor: Cursor): T };

const token: ListItem<string> = { bytes: 4, read: (reader, c) => reader.token(c.u32(A_TOKEN), c.at - 4) };
const string: ListItem<string> = { bytes: 4, read: (reader, c) => reader.string(c.u32(A_STRING), c.at - 4) };
const path: ListItem<string> = { bytes: 4, read: (reader, c) => reader.path(c.u32(A_PATH), c.at - 4) };
const integers: Readonly<Record<number, ListItem<bigint>>> = {
  [NON_ARRAY_TYPES.intListOp]: { bytes: 4, read: (_, c) => BigInt(c.i32(AN_INTEGER)) },
  [NON_ARRAY_TYPES.uintListOp]: { bytes: 4, read: (_, c) => BigInt(c.u32(AN_INTEGER)) },
  [NON_ARRAY_TYPES.int64ListOp]: { bytes: 8, read: (_, c) => c.big(AN_INTEGER) },
  [NON_ARRAY_TYPES.uint64ListOp]: { bytes: 8, read: (_, c) => BigInt.asUintN(64, c.big(AN_INTEGER)) },
};

const reference: ListItem<ReferenceSpec> = {
  bytes: 32,
  read: (reader, cursor) => {
    const arc = readTarget(reader, cursor);
    const offset = readOffset(cursor);
    const customData = reader.dictionary(cursor);
    return { ...arc, ...offset, ...(customData.size > 0 ? { customData } : {}) };
  },
};
/** Payloads have offsets since 0.8. */
const payload: ListItem<ReferenceSpec> = {
  bytes: 8,
  read: (reader, cursor) => {
    const arc = readTarget(reader, cursor);
    return { ...arc, ...(reader.source.version < 8 ? { offset: 0, scale: 1 } : readOffset(cursor)) };
  },
};

function readTarget(reader: ValueDecoder, cursor: Cursor): Pick<ReferenceSpec, 'asset' | 'path'> {
  const { at } = cursor;
  const asset = reader.string(cursor.u32(AN_ASSET), at);
  return { asset, path: reader.path(cursor.u32(A_PATH), at + 4) };
}

const readOffset = (cursor: Cursor): Pick<ReferenceSpec, 'offset' | 'scale'> => ({
  offset: cursor.f64(AN_OFFSET),
  scale: cursor.f64(A_SCALE),
});

function readItems<T>(reader: ValueDecoder, cursor: Cursor, { bytes, read }: ListItem<T>): T[] {
  const count = cursor.count(msg`items of a list`, bytes);
  reader.source.spend(ITEM_BYTES * count, msg`a list of ${count} items`, cursor.at);
  return Array.from({ length: count }, () => read(reader, cursor));
}

/** A list op of one of the eight kinds; undefined for other types. */
export function readListOp(reader: ValueDecoder, rep: ValueRep, cursor: Cursor): FieldValue | undefined {
  const op = <T>(item: ListItem<T>): ListOp<T> => (rep.isInlined ? {} : readOp(reader, cursor, item));
  switch (rep.type) {
    case NON_ARRAY_TYPES.tokenListOp:
      return { type: 'texts', op: op(token) };
    case NON_ARRAY_TYPES.stringListOp:
      return { type: 'texts', op: op(string) };
    case NON_ARRAY_TYPES.pathListOp:
      return { type: 'paths', op: op(path) };
    case NON_ARRAY_TYPES.referenceListOp:
      return { type: 'arcs', op: op(reference) };
    case NON_ARRAY_TYPES.payloadListOp:
      return { type: 'arcs', op: op(payload) };
    case NON_ARRAY_TYPES.unregisteredListOp:
      return { type: 'unregistereds', op: op({ bytes: 8, read: (r, c) => r.unregisteredItem(c) }) };
    default: {
      const item = integers[rep.type];
      return item && { type: 'integers', op: op(item) };
    }
  }
}

function readOp<T>(reader: ValueDecoder, cursor: Cursor, item: ListItem<T>): ListOp<T> {
  const bits = cursor.u8(msg`a list op`);
  const op: ListOp<T> = bits & 1 ? { explicit: [] } : {};
  for (const [bit, list] of LIST_BITS) if (bits & bit) op[list] = readItems(reader, cursor, item);
  return op;
}

/** A plain list of one of the kinds that fields have; undefined for other types. */
export function readVector(reader: ValueDecoder, rep: ValueRep, cursor: Cursor): FieldValue | undefined {
  const items = <T>(item: ListItem<T>): T[] => (rep.isInlined ? [] : readItems(reader, cursor, item));
  switch (rep.type) {
    case NON_ARRAY_TYPES.tokenVector:
      return { type: 'names', data: items(token) };
    case NON_ARRAY_TYPES.stringVector:
      return { type: 'names', data: items(string) };
    case NON_ARRAY_TYPES.pathVector:
      return { type: 'names', data: items(path) };
    case NON_ARRAY_TYPES.doubleVector:
      return { type: 'times', data: Float64Array.from(items({ bytes: 8, read: (_, c) => c.f64(A_NUMBER) })) };
    case NON_ARRAY_TYPES.offsetVector:
      return { type: 'offsets', data: items({ bytes: 16, read: (_, c) => readOffset(c) }) };
    case NON_ARRAY_TYPES.relocates:
      return { type: 'relocates', data: items({ bytes: 8, read: readRelocate }) };
    case NON_ARRAY_TYPES.payload:
      return { type: 'arcs', op: { explicit: [payload.read(reader, cursor)].filter((a) => a.asset || a.path) } };
    default:
      return undefined;
  }
}

const readRelocate = (reader: ValueDecoder, cursor: Cursor): readonly [from: string, to: string] => [
  path.read(reader, cursor),
  path.read(reader, cursor),
];

/** Variant set → variant. */
export function readSelections(reader: ValueDecoder, cursor: Cursor): Map<string, string> {
  const pairs = readItems(reader, cursor, {
    bytes: 8,
    read: (r, c): [string, string] => [string.read(r, c), string.read(r, c)],
  });
  return new Map(pairs);
}
