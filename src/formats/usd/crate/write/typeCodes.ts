import { ARRAY_TYPES, type ArrayType } from '../values/crateTypes.ts';

/** Type of values that can stand in arrays, and its number. */
export type CodedType<K extends ArrayType['kind'] = ArrayType['kind']> = Extract<ArrayType, { kind: K }> & {
  readonly code: number;
};

const BY_STORAGE: ReadonlyMap<string, CodedType> = new Map(
  [...ARRAY_TYPES].map(([code, type]) => [type.storage, { ...type, code }]),
);

/** `float3` → its number and how it is stored; undefined for types that have no arrays. */
export const codedType = (storage: string): CodedType | undefined => BY_STORAGE.get(storage);
