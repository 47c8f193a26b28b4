/** A tensor of a network: its dimensions, and its values in row-major order. */
export interface Tensor {
  readonly dims: readonly number[];
  readonly values: Float32Array;
}

const MAGIC = 0x41d7;

/**
 * Reads the tensors of a TZA file, the format of Open Image Denoise's weights: magic number, version, offset of a table of contents, and halves.
 * Source: core/tza.cpp of Open Image Denoise 2.
 */
export function parseTza(file: Uint8Array): ReadonlyMap<string, Tensor> {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (view.getUint16(0, true) !== MAGIC || view.getUint8(2) !== 2) throw new Error('these are no weights in TZA 2');
  let at = Number(view.getBigUint64(4, true));
  const text = (length: number): string => {
    at += length;
    return String.fromCharCode(...file.subarray(at - length, at));
  };
  const count = view.getUint32(at, true);
  at += 4;
  const tensors = new Map<string, Tensor>();
  for (let k = 0; k < count; k++) {
    const length = view.getUint16(at, true);
    at += 2;
    const name = text(length);
    const rank = view.getUint8(at++);
    const dims = Array.from({ length: rank }, (_, i) => view.getUint32(at + 4 * i, true));
    at += 4 * rank;
    const layout = text(rank);
    if (text(1) !== 'h' || !['x', 'oihw'].includes(layout)) throw new Error(`${name} has an unknown layout`);
    const offset = Number(view.getBigUint64(at, true));
    at += 8;
    const size = dims.reduce((product, dim) => product * dim, 1);
    const values = Float32Array.from({ length: size }, (_, i) => half(view.getUint16(offset + 2 * i, true)));
    tensors.set(name, { dims, values });
  }
  return tensors;
}

/** The value of an IEEE 754 half. */
function half(bits: number): number {
  const [sign, exponent, fraction] = [bits & 0x8000 ? -1 : 1, (bits >> 10) & 31, bits & 1023];
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}
