import type { Dictionary, MetadataValue, ReferenceSpec, Spline, TimeSamples, Value } from '../../layer/layer.ts';
import type { CrateSource, Cursor } from '../structure/crateSource.ts';
import type { TextTable } from './arrays.ts';

/** What a field can hold: values and metadata of a layer, and what its structure is made of. */
export type FieldValue =
  | MetadataValue
  | { readonly type: 'timeSamples'; readonly data: TimeSamples }
  | { readonly type: 'spline'; readonly data: Spline }
  | { readonly type: 'names'; readonly data: readonly string[] }
  | { readonly type: 'times'; readonly data: Float64Array }
  | { readonly type: 'offsets'; readonly data: readonly Pick<ReferenceSpec, 'offset' | 'scale'>[] }
  | { readonly type: 'specifier' | 'permission' | 'variability'; readonly data: number };

/** What one entry of a dictionary or one sample costs. */
export const ENTRY_BYTES = 64;

/** What the reader of one kind of value needs to read those inside it. */
export interface ValueDecoder extends TextTable {
  readonly source: CrateSource;
  /** Empty for the invalid path. */
  path(index: number, at?: number): string;
  /** The value of a representation that lies in the file. */
  readAt(cursor: Cursor): FieldValue;
  /** The value whose representation is where the next offset leads; what is read next follows it. */
  readNested(cursor: Cursor): FieldValue;
  /** `{ key: value, … }` */
  dictionary(cursor: Cursor): Dictionary;
  /** One item of a list of unregistered texts. */
  unregisteredItem(cursor: Cursor): Value;
  /** A value of a kind that dictionaries and samples hold; others are refused. */
  plain(value: FieldValue, at?: number): Value;
}
