/*
 * Encodes plain data as bytes for another process, as `postMessage` does between threads. Layout: the length of a table [u32], the table as JSON, then the typed
 * arrays, each aligned to 8 bytes. The table has an entry for each object, array and typed array, the root first. Shared objects, such as a mesh with many
 * instances, are sent once and shared again after decoding.
 */

const ARRAYS = {
  Int8Array,
  Uint8Array,
  Uint8ClampedArray,
  Int16Array,
  Uint16Array,
  Int32Array,
  Uint32Array,
  Float32Array,
  Float64Array,
} as const;
type TransferArrayName = keyof typeof ARRAYS;
type TransferArray = InstanceType<(typeof ARRAYS)[TransferArrayName]>;

/** A value in the table: strings, booleans, finite numbers and null as they are; references as an array with the index of an entry; values unknown to JSON by name. */
type TransferValue = string | number | boolean | null | readonly [place: number] | { readonly special: Special };
type Special = 'undefined' | 'NaN' | 'Infinity' | '-Infinity' | '-0';

type TransferEntry =
  | { readonly list: TransferValue[] }
  | { readonly object: [name: string, value: TransferValue][] }
  | { readonly array: TransferArrayName; readonly at: number; readonly length: number };

const SPECIAL: Record<Special, number | undefined> = {
  undefined,
  NaN: Number.NaN,
  Infinity: Number.POSITIVE_INFINITY,
  '-Infinity': Number.NEGATIVE_INFINITY,
  '-0': -0,
};
const ALIGNED = 8;
const aligned = (bytes: number): number => Math.ceil(bytes / ALIGNED) * ALIGNED;

/** Encodes objects, arrays, typed arrays, strings, numbers, booleans, null and undefined, nested as deep as scenes are; throws for anything else. */
export function encodeTransfer(value: object): Uint8Array<ArrayBuffer> {
  const { entries, arrays, size } = new TransferTable(value);
  const table = new TextEncoder().encode(JSON.stringify(entries));
  const start = aligned(4 + table.length);
  const bytes = new Uint8Array(start + size);
  new DataView(bytes.buffer).setUint32(0, table.length, true);
  bytes.set(table, 4);
  for (const { at, data } of arrays)
    bytes.set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), start + at);
  return bytes;
}

class TransferTable {
  readonly entries: TransferEntry[] = [];
  readonly arrays: { readonly at: number; readonly data: TransferArray }[] = [];
  /** Size of all arrays [bytes]. */
  size = 0;
  private readonly places = new Map<object, number>();

  constructor(root: object) {
    this.place(root);
  }

  private value(item: unknown): TransferValue {
    if (typeof item === 'number') return numberValue(item);
    if (item === undefined) return { special: 'undefined' };
    if (item === null || typeof item === 'string' || typeof item === 'boolean') return item;
    if (typeof item === 'object') return [this.place(item)];
    throw notTransferable(typeof item);
  }

  private place(item: object): number {
    const known = this.places.get(item);
    if (known !== undefined) return known;
    const place = this.entries.length;
    this.places.set(item, place);
    if (ArrayBuffer.isView(item)) this.addNumbers(item);
    else if (Array.isArray(item)) this.addList(item);
    else this.addObject(item);
    return place;
  }

  private addNumbers(view: ArrayBufferView): void {
    const name = (Object.keys(ARRAYS) as TransferArrayName[]).find((each) => view instanceof ARRAYS[each]);
    if (!name) throw notTransferable(view.constructor.name);
    const data = view as TransferArray;
    this.entries.push({ array: name, at: this.size, length: data.length });
    this.arrays.push({ at: this.size, data });
    this.size = aligned(this.size + data.byteLength);
  }

  /** An object's entry precedes those of its contents. */
  private addList(items: readonly unknown[]): void {
    const list: TransferValue[] = [];
    this.entries.push({ list });
    for (const item of items) list.push(this.value(item));
  }

  private addObject(item: object): void {
    const prototype: unknown = Object.getPrototypeOf(item);
    if (prototype !== Object.prototype && prototype !== null) throw notTransferable(item.constructor.name);
    const object: [string, TransferValue][] = [];
    this.entries.push({ object });
    for (const [name, part] of Object.entries(item)) object.push([name, this.value(part)]);
  }
}

function numberValue(value: number): TransferValue {
  if (Object.is(value, -0)) return { special: '-0' };
  return Number.isFinite(value) ? value : { special: String(value) as Special };
}

const notTransferable = (what: string): TypeError => new TypeError(`a ${what} cannot be sent to another process`);

/** Decodes data. Its typed arrays are views of `buffer`. */
export function decodeTransfer(buffer: ArrayBuffer): unknown {
  const length = new DataView(buffer).getUint32(0, true);
  const start = aligned(4 + length);
  const entries = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as readonly TransferEntry[];
  const made = entries.map((entry) => {
    if ('array' in entry) return new ARRAYS[entry.array](buffer, start + entry.at, entry.length);
    return 'list' in entry ? new Array<unknown>(entry.list.length) : ({} as Record<string, unknown>);
  });
  const read = (value: TransferValue): unknown => {
    if (typeof value !== 'object' || value === null) return value;
    return 'special' in value ? SPECIAL[value.special] : made[value[0]];
  };
  entries.forEach((entry, i) => {
    const whole = made[i] as Record<string | number, unknown>;
    const parts = 'list' in entry ? entry.list.entries() : 'object' in entry ? entry.object : [];
    for (const [name, value] of parts) whole[name] = read(value);
  });
  return made[0];
}
