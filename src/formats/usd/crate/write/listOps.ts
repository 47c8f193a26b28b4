import { msg } from '../../../../messages/message.ts';
import type { ListOp, ReferenceSpec, Value } from '../../layer/layer.ts';
import { NON_ARRAY_TYPES } from '../values/crateTypes.ts';
import { LIST_BITS } from '../values/listOps.ts';
import { ByteSink } from './byteSink.ts';
import { stored } from './rep.ts';
import type { ValuePacker } from './valuePacker.ts';

type ItemWriter<T> = (packer: ValuePacker, sink: ByteSink, item: T) => void;

const token: ItemWriter<string> = ({ tokens }, sink, text) => sink.u32(tokens.index(text));
const string: ItemWriter<string> = ({ tokens }, sink, text) => sink.u32(tokens.stringIndex(text));
const path: ItemWriter<string> = ({ paths }, sink, text) => sink.u32(paths.index(text));

const offset = (sink: ByteSink, { offset: shift, scale }: Pick<ReferenceSpec, 'offset' | 'scale'>): void => {
  sink.f64(shift);
  sink.f64(scale);
};

const payload: ItemWriter<ReferenceSpec> = (packer, sink, arc) => {
  if (arc.customData) packer.fail(msg`a payload has customData, which binary files keep of references only`);
  string(packer, sink, arc.asset);
  path(packer, sink, arc.path);
  offset(sink, arc);
};

const reference: ItemWriter<ReferenceSpec> = (packer, sink, arc) => {
  string(packer, sink, arc.asset);
  path(packer, sink, arc.path);
  offset(sink, arc);
  packer.writeDictionary(sink, arc.customData ?? new Map());
};

function packOp<T>(packer: ValuePacker, type: number, op: ListOp<T>, write: ItemWriter<T>): bigint {
  const sink = new ByteSink();
  const lists = LIST_BITS.filter(([, list]) => (op[list] ?? []).length > 0);
  sink.u8(lists.reduce((bits, [bit]) => bits | bit, op.explicit ? 1 : 0));
  for (const [, list] of lists) writeItems(packer, sink, op[list]!, write);
  return stored(type, packer.place(sink.bytes));
}

function writeItems<T>(packer: ValuePacker, sink: ByteSink, items: readonly T[], write: ItemWriter<T>): void {
  sink.u64(items.length);
  for (const item of items) write(packer, sink, item);
}

export const packTokens = (packer: ValuePacker, op: ListOp<string>): bigint =>
  packOp(packer, NON_ARRAY_TYPES.tokenListOp, op, token);
export const packStrings = (packer: ValuePacker, op: ListOp<string>): bigint =>
  packOp(packer, NON_ARRAY_TYPES.stringListOp, op, string);
export const packPaths = (packer: ValuePacker, op: ListOp<string>): bigint =>
  packOp(packer, NON_ARRAY_TYPES.pathListOp, op, path);
export const packReferences = (packer: ValuePacker, op: ListOp<ReferenceSpec>): bigint =>
  packOp(packer, NON_ARRAY_TYPES.referenceListOp, op, reference);
export const packPayloads = (packer: ValuePacker, op: ListOp<ReferenceSpec>): bigint =>
  packOp(packer, NON_ARRAY_TYPES.payloadListOp, op, payload);

/** With 64 bits, with a sign where all items allow it. */
export function packIntegers(packer: ValuePacker, op: ListOp<bigint>): bigint {
  const items = Object.values(op).flat() as bigint[];
  const allAre = (wrap: (bits: number, x: bigint) => bigint): boolean => items.every((x) => wrap(64, x) === x);
  const type = allAre(BigInt.asIntN) ? NON_ARRAY_TYPES.int64ListOp : NON_ARRAY_TYPES.uint64ListOp;
  if (type === NON_ARRAY_TYPES.uint64ListOp && !allAre(BigInt.asUintN))
    packer.fail(msg`of the integers ${items.join(', ').slice(0, 80)} some do not fit 64 bits`);
  return packOp(packer, type, op, (_, sink, item) => sink.big(item));
}

/** A list of texts of a key that no schema knows: OpenUSD keeps the text of the whole list as one item. */
export function packUnregistereds(packer: ValuePacker, op: ListOp<Value>): bigint {
  const textOf = (item: Value): string =>
    item.type === 'unregistered'
      ? item.data
      : packer.fail(msg`a list of unknown metadata has an item of type ${item.type}`);
  const joined = Object.entries(op).map(([list, items]) => [
    list,
    items.length > 0 ? [items.map(textOf).join(', ')] : [],
  ]);
  return packer.unregistered(
    packOp<string>(packer, NON_ARRAY_TYPES.unregisteredListOp, Object.fromEntries(joined), (_, sink, text) =>
      packer.writeNested(sink, packer.pack({ type: 'string', data: text })),
    ),
  );
}

function packItems<T>(packer: ValuePacker, type: number, items: readonly T[], write: ItemWriter<T>): bigint {
  const sink = new ByteSink();
  writeItems(packer, sink, items, write);
  return stored(type, packer.place(sink.bytes));
}

export const packNames = (packer: ValuePacker, names: readonly string[]): bigint =>
  packItems(packer, NON_ARRAY_TYPES.tokenVector, names, token);
export const packAssets = (packer: ValuePacker, assets: readonly string[]): bigint =>
  packItems(packer, NON_ARRAY_TYPES.stringVector, assets, string);
export const packOffsets = (packer: ValuePacker, arcs: readonly ReferenceSpec[]): bigint =>
  packItems(packer, NON_ARRAY_TYPES.offsetVector, arcs, (_, sink, arc) => offset(sink, arc));

export function packRelocates(packer: ValuePacker, pairs: readonly (readonly [from: string, to: string])[]): bigint {
  packer.need(11);
  return packItems(packer, NON_ARRAY_TYPES.relocates, pairs, (_, sink, pair) => {
    for (const end of pair) path(packer, sink, end);
  });
}

/** Variant set → variant. */
export const packSelections = (packer: ValuePacker, selections: ReadonlyMap<string, string>): bigint =>
  packItems(packer, NON_ARRAY_TYPES.variantSelections, [...selections], (_, sink, pair) => {
    for (const text of pair) string(packer, sink, text);
  });
