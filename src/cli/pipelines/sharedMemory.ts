/**
 * Copies plain data with its typed arrays in shared memory, so that threads that it is sent to share the bytes. An array
 * that occurs several times is copied once.
 */
export function toSharedMemory<T>(data: T): T {
  const copies = new Map<object, object>();
  const copy = (value: unknown): unknown => {
    if (typeof value !== 'object' || value === null) return value;
    const made = copies.get(value) ?? (ArrayBuffer.isView(value) ? sharedArray(value) : copyContainer(value, copy));
    copies.set(value, made);
    return made;
  };
  return copy(data) as T;
}

function copyContainer(value: object, copy: (part: unknown) => unknown): object {
  if (Array.isArray(value)) return value.map(copy);
  if (value instanceof Map) return new Map([...value].map(([key, part]) => [copy(key), copy(part)]));
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, copy(part)]));
}

const TYPED_ARRAYS: readonly (new (bytes: SharedArrayBuffer) => ArrayBufferView)[] = [
  Float32Array,
  Float64Array,
  Uint8Array,
  Uint16Array,
  Int32Array,
  Uint32Array,
];

function sharedArray(view: ArrayBufferView): object {
  const bytes = new SharedArrayBuffer(view.byteLength);
  new Uint8Array(bytes).set(new Uint8Array(view.buffer, view.byteOffset, view.byteLength));
  const Kind = TYPED_ARRAYS.find((kind) => view instanceof kind);
  if (!Kind) throw new TypeError(`no shared ${view.constructor.name}`);
  return new Kind(bytes);
}
