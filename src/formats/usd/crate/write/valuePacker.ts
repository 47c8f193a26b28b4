import { type Message, msg } from '../../../../messages/message.ts';
import type { Dictionary, TimeSamples, Value } from '../../layer/layer.ts';
import { NON_ARRAY_TYPES } from '../values/crateTypes.ts';
import { packArray } from './arrays.ts';
import { ByteSink } from './byteSink.ts';
import type { PackContext } from './packContext.ts';
import type { PathTable } from './pathTable.ts';
import { inlined, stored } from './rep.ts';
import { packScalar } from './scalars.ts';
import type { TokenTable } from './tokenTable.ts';
import { codedType } from './typeCodes.ts';
import type { ValueStore } from './valueStore.ts';

/** Versions of the format that a kind of value needs (OpenUSD, crateFile.cpp): 9 is 0.9. */
const NEEDED_VERSIONS: ReadonlyMap<string, number> = new Map([
  ['timecode', 9],
  ['timecode[]', 9],
  ['pathExpression', 10],
  ['pathExpression[]', 10],
]);

/** An offset to what follows right behind it. */
const NEXT = 8;

/** Makes representations of values, and puts into the file what they do not hold. */
export class ValuePacker implements PackContext {
  readonly tokens: TokenTable;
  readonly paths: PathTable;
  /** Of the format that what is packed so far needs. */
  version = 8;
  readonly fail: (message: Message) => never;
  private readonly values: ValueStore;
  /** Arrays that several values share, such as equal samples. */
  private readonly arrays = new WeakMap<object, bigint>();

  constructor(tokens: TokenTable, paths: PathTable, values: ValueStore, fail: (message: Message) => never) {
    this.tokens = tokens;
    this.paths = paths;
    this.values = values;
    this.fail = fail;
  }

  place(bytes: Uint8Array, alignment?: number): number {
    return this.values.place(bytes, alignment);
  }

  need(version: number): void {
    this.version = Math.max(this.version, version);
  }

  pack(value: Value): bigint {
    switch (value.type) {
      case 'blocked':
        return inlined(NON_ARRAY_TYPES.blocked, 0);
      case 'animationBlock':
        return inlined(NON_ARRAY_TYPES.animationBlock, 0);
      case 'dictionary':
        return this.dictionary(value.data);
      case 'unregistered':
        return this.unregistered(this.pack({ type: 'string', data: value.data }));
      default:
        return this.typed(value);
    }
  }

  private typed(value: Extract<Value, { readonly data: unknown }>): bigint {
    this.need(NEEDED_VERSIONS.get(value.type) ?? 0);
    const isArray = value.type.endsWith('[]');
    const type = codedType(isArray ? value.type.slice(0, -2) : value.type);
    if (!type) return this.fail(msg`values of type ${value.type} cannot be written`);
    if (!isArray) return packScalar(this, type, value.data);
    // Of a value that is read or made anew each time this is another each time.
    const data = value.data as Parameters<typeof packArray>[2];
    const known = this.arrays.get(data);
    if (known !== undefined) return known;
    const rep = packArray(this, type, data);
    this.arrays.set(data, rep);
    return rep;
  }

  dictionary(entries: Dictionary): bigint {
    if (entries.size === 0) return inlined(NON_ARRAY_TYPES.dictionary, 0);
    const sink = new ByteSink();
    this.writeDictionary(sink, entries);
    return stored(NON_ARRAY_TYPES.dictionary, this.place(sink.bytes));
  }

  /** How many entries, then each key and, behind an offset, its value. */
  writeDictionary(sink: ByteSink, entries: Dictionary): void {
    sink.u64(entries.size);
    for (const [key, value] of entries) {
      sink.u32(this.tokens.stringIndex(key));
      this.writeNested(sink, this.pack(value));
    }
  }

  writeNested(sink: ByteSink, rep: bigint): void {
    sink.u64(NEXT);
    sink.big(rep);
  }

  /** Metadata of a key that no schema knows, around a text, a dictionary, or a list of texts. */
  unregistered(rep: bigint): bigint {
    const sink = new ByteSink();
    this.writeNested(sink, rep);
    return stored(NON_ARRAY_TYPES.unregistered, this.place(sink.bytes));
  }

  /** The times, which several attributes may share, behind an offset; then, behind another, the values. */
  timeSamples({ times, values }: TimeSamples): bigint {
    const shared = new ByteSink();
    shared.u64(times.length);
    shared.append(new Uint8Array(times.buffer, times.byteOffset, times.byteLength));
    const reps = values.map((value) => this.pack(value));
    const sink = new ByteSink();
    this.writeNested(sink, stored(NON_ARRAY_TYPES.doubleVector, this.place(shared.bytes)));
    sink.u64(NEXT);
    sink.u64(reps.length);
    for (const rep of reps) sink.big(rep);
    return stored(NON_ARRAY_TYPES.timeSamples, this.place(sink.bytes));
  }
}
