import { msg } from '../../../../messages/message.ts';
import type { Value } from '../../layer/layer.ts';
import { type CrateSource, Cursor } from '../structure/crateSource.ts';
import type { Structure } from '../structure/structure.ts';
import { readArray } from './arrays.ts';
import { ARRAY_TYPES, type ArrayType, NON_ARRAY_TYPES } from './crateTypes.ts';
import { ENTRY_BYTES, type FieldValue, type ValueDecoder } from './fieldValue.ts';
import { readListOp, readSelections, readVector } from './listOps.ts';
import { readScalar } from './scalars.ts';
import { readSpline } from './splines.ts';
import { readTimeSamples } from './timeSamples.ts';
import { ValueRep } from './valueRep.ts';

const A_VALUE = msg`a value`;
const PLACE_OF_VALUE = msg`the place of a value`;

/** Maximum nesting of values. */
const MAX_DEPTH = 64;

/** Types that can contain dictionaries are not cached: shared ones could reference each other twice per level, 2⁶⁴ entries in all. */
const NOT_CACHED: ReadonlySet<number> = new Set([
  NON_ARRAY_TYPES.dictionary,
  NON_ARRAY_TYPES.value,
  NON_ARRAY_TYPES.unregistered,
]);

/** Decodes values by their representations. Values in the file are cached: samples of equal arrays share one array. */
export class ValueReader implements ValueDecoder {
  readonly source: CrateSource;
  private readonly structure: Structure;
  /** Cached values by type and flags, then by offset. */
  private readonly cache = new Map<number, Map<number, FieldValue>>();
  private depth = 0;

  constructor(source: CrateSource, structure: Structure) {
    this.source = source;
    this.structure = structure;
  }

  token(index: number, at?: number): string {
    const { tokens } = this.structure;
    return tokens[index] ?? this.source.fail(msg`there is no token ${index}; there are ${tokens.length}`, at);
  }

  string(index: number, at?: number): string {
    const { strings } = this.structure;
    if (index >= strings.length) this.source.fail(msg`there is no string ${index}; there are ${strings.length}`, at);
    return this.token(strings[index], at);
  }

  /** Empty for the invalid path. */
  path(index: number, at?: number): string {
    const { paths } = this.structure;
    if (index >= paths.length) this.source.fail(msg`there is no path ${index}; there are ${paths.length}`, at);
    return paths[index]?.path ?? '';
  }

  /** The value of a representation. */
  read(rep: ValueRep): FieldValue {
    const type = ARRAY_TYPES.get(rep.type);
    if (type && !rep.isArray) return readScalar(this.source, rep, type, this);
    if (rep.isInlined || NOT_CACHED.has(rep.type)) return this.decode(rep, type);
    const known = this.cache.get(rep.typeAndFlags) ?? new Map<number, FieldValue>();
    this.cache.set(rep.typeAndFlags, known);
    const before = known.get(rep.offset);
    if (before) return before;
    const value = this.decode(rep, type);
    this.source.spend(ENTRY_BYTES, A_VALUE, rep.at);
    known.set(rep.offset, value);
    return value;
  }

  /** The value of a representation that lies in the file. */
  readAt(cursor: Cursor): FieldValue {
    const at = cursor.pass(8, A_VALUE);
    const { view, base } = this.source;
    const low = view.getUint32(at - base, true);
    return this.read(new ValueRep(this.source, low, view.getUint32(at - base + 4, true), at));
  }

  /** The value whose representation is where the next offset leads; what is read next follows it. */
  readNested(cursor: Cursor): FieldValue {
    const { at } = cursor;
    cursor.at = at + cursor.i64(PLACE_OF_VALUE);
    return this.readAt(cursor);
  }

  /** A value of a kind that dictionaries and samples hold. */
  plain(value: FieldValue, at?: number): Value {
    switch (value.type) {
      case 'timeSamples':
      case 'spline':
      case 'names':
      case 'times':
      case 'offsets':
      case 'specifier':
      case 'permission':
      case 'variability':
      case 'texts':
      case 'integers':
      case 'unregistereds':
      case 'paths':
      case 'arcs':
      case 'subLayers':
      case 'relocates':
      case 'texts-by-name':
        return this.source.fail(msg`a value of kind ${value.type} stands where none can`, at);
      default:
        return value;
    }
  }

  private decode(rep: ValueRep, type: ArrayType | undefined): FieldValue {
    if (type) return readArray(this.source, rep, type, this);
    if (rep.isArray) this.source.fail(msg`there are no arrays of type ${rep.type}`, rep.at);
    if (this.depth === MAX_DEPTH) this.source.fail(msg`values are nested more than ${MAX_DEPTH} deep`, rep.at);
    this.depth++;
    const value = this.decodeNonArray(rep, new Cursor(this.source, rep.offset));
    this.depth--;
    return value;
  }

  private decodeNonArray(rep: ValueRep, cursor: Cursor): FieldValue {
    switch (rep.type) {
      case NON_ARRAY_TYPES.blocked:
        return { type: 'blocked' };
      case NON_ARRAY_TYPES.animationBlock:
        return { type: 'animationBlock' };
      case NON_ARRAY_TYPES.specifier:
        return { type: 'specifier', data: enumValue(rep, cursor) };
      case NON_ARRAY_TYPES.permission:
        return { type: 'permission', data: enumValue(rep, cursor) };
      case NON_ARRAY_TYPES.variability:
        return { type: 'variability', data: enumValue(rep, cursor) };
      case NON_ARRAY_TYPES.dictionary:
        return { type: 'dictionary', data: rep.isInlined ? new Map() : this.dictionary(cursor) };
      case NON_ARRAY_TYPES.timeSamples:
        return { type: 'timeSamples', data: readTimeSamples(this, rep, cursor) };
      case NON_ARRAY_TYPES.spline:
        return { type: 'spline', data: readSpline(this, rep, cursor) };
      case NON_ARRAY_TYPES.variantSelections:
        return { type: 'texts-by-name', data: rep.isInlined ? new Map() : readSelections(this, cursor) };
      case NON_ARRAY_TYPES.value:
        return this.readNested(cursor);
      case NON_ARRAY_TYPES.unregistered:
        return this.unregistered(cursor, rep.at);
      default:
        return readListOp(this, rep, cursor) ?? readVector(this, rep, cursor) ?? this.unknown(rep);
    }
  }

  private unknown(rep: ValueRep): never {
    return this.source.fail(msg`there is no type ${rep.type}`, rep.at);
  }

  /** `{ key: value, … }`: how many, then each key and, behind an offset, its value. */
  dictionary(cursor: Cursor): Map<string, Value> {
    const count = cursor.count(msg`entries of a dictionary`, 20);
    this.source.spend(ENTRY_BYTES * count, msg`a dictionary`, cursor.at);
    const entries = new Map<string, Value>();
    for (let i = 0; i < count; i++) {
      const { at } = cursor;
      const key = this.string(cursor.u32(msg`the key of a dictionary entry`), at);
      entries.set(key, this.plain(this.readNested(cursor), at));
    }
    return entries;
  }

  /** Metadata of a key that no schema knows: its text, a dictionary, or a list of texts. */
  private unregistered(cursor: Cursor, at: number | undefined): FieldValue {
    const value = this.readNested(cursor);
    if (value.type === 'string') return { type: 'unregistered', data: value.data };
    if (value.type === 'dictionary' || value.type === 'unregistereds') return value;
    return this.source.fail(msg`unregistered metadata of kind ${value.type}`, at);
  }

  /** One item of a list of unregistered texts. */
  unregisteredItem(cursor: Cursor): Value {
    const { at } = cursor;
    const value = this.readNested(cursor);
    return value.type === 'string' ? { type: 'unregistered', data: value.data } : this.plain(value, at);
  }
}

const enumValue = (rep: ValueRep, cursor: Cursor): number => (rep.isInlined ? rep.low : cursor.i32(A_VALUE));
