/** Filters of EXT_meshopt_compression (appendix B) and KHR_meshopt_compression: decode quantized values in place. */

type MeshoptFilter = (bytes: Uint8Array<ArrayBuffer>, stride: number) => void;

export const FILTERS: ReadonlyMap<
  string,
  { readonly strides: (stride: number) => boolean; readonly apply: MeshoptFilter }
> = new Map([
  ['OCTAHEDRAL', { strides: (n) => n === 4 || n === 8, apply: octahedral }],
  ['QUATERNION', { strides: (n) => n === 8, apply: quaternion }],
  ['EXPONENTIAL', { strides: (n) => n % 4 === 0, apply: exponential }],
  ['COLOR', { strides: (n) => n === 4 || n === 8, apply: color }],
]);

/** Rounds half away from zero, as the reference decoder does. */
const round = (x: number): number => Math.trunc(x + (x < 0 ? -0.5 : 0.5));

/** Octahedral unit vectors, |x| + |y| + |z| = 1, whose scale is stored in z; w is unchanged. */
function octahedral(bytes: Uint8Array<ArrayBuffer>, stride: number): void {
  const values = stride === 4 ? new Int8Array(bytes.buffer) : new Int16Array(bytes.buffer);
  const most = stride === 4 ? 127 : 32767;
  for (let i = 0; i < values.length; i += 4) {
    const size = values[i + 2];
    let [x, y] = [values[i] / size, values[i + 1] / size];
    const z = 1 - Math.abs(x) - Math.abs(y);
    // Unfold the lower half.
    const fold = Math.max(-z, 0);
    x -= x >= 0 ? fold : -fold;
    y -= y >= 0 ? fold : -fold;
    const scale = most / Math.hypot(x, y, z);
    values.set([round(x * scale), round(y * scale), round(z * scale)], i);
  }
}

/** Unit quaternions without the largest component, whose index is in the lowest bits of the fourth. */
function quaternion(bytes: Uint8Array<ArrayBuffer>): void {
  const values = new Int16Array(bytes.buffer);
  for (let i = 0; i < values.length; i += 4) {
    const greatest = values[i + 3] & 3;
    const scale = Math.SQRT1_2 / (values[i + 3] | 3);
    const others = [values[i] * scale, values[i + 1] * scale, values[i + 2] * scale];
    const w = Math.sqrt(Math.max(0, 1 - others.reduce((sum, x) => sum + x * x, 0)));
    for (const [k, x] of [w, ...others].entries()) values[i + ((greatest + k) & 3)] = round(x * 32767);
  }
}

/** A signed exponent in the high byte, a signed mantissa of 24 bits below it. */
function exponential(bytes: Uint8Array<ArrayBuffer>): void {
  const packed = new Int32Array(bytes.buffer);
  const values = new Float32Array(bytes.buffer);
  for (let i = 0; i < packed.length; i++) values[i] = ((packed[i] << 8) >> 8) * 2 ** (packed[i] >> 24);
}

/** Luma and two differences of colour (YCoCg), scaled by the power of two that alpha's highest bit tells. */
function color(bytes: Uint8Array<ArrayBuffer>, stride: number): void {
  const values = stride === 4 ? new Uint8Array(bytes.buffer) : new Uint16Array(bytes.buffer);
  const signed = stride === 4 ? new Int8Array(bytes.buffer) : new Int16Array(bytes.buffer);
  const most = stride === 4 ? 255 : 65535;
  for (let i = 0; i < values.length; i += 4) {
    const [y, co, cg, packed] = [values[i], signed[i + 1], signed[i + 2], values[i + 3]];
    const size = 2 ** (32 - Math.clz32(packed)) - 1;
    const alpha = packed & (size >> 1);
    const rgba = [y + co - cg, y + cg, y - co - cg, (alpha << 1) | (alpha & 1)];
    values.set(
      rgba.map((x) => round((x * most) / size)),
      i,
    );
  }
}
