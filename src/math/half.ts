/** IEEE 754 half precision ↔ number; bits as an unsigned 16-bit integer. */

const scratch = new DataView(new ArrayBuffer(4));

/** The bits of the nearest half, ties to even; infinity above 65504. */
export function toHalf(value: number): number {
  scratch.setFloat32(0, value);
  const bits = scratch.getUint32(0);
  const sign = (bits >>> 16) & 0x8000;
  const exponent = (bits >>> 23) & 0xff;
  const mantissa = bits & 0x7fffff;
  if (exponent === 0xff) return sign | 0x7c00 | (mantissa ? 0x200 : 0);
  const biased = exponent - 127 + 15;
  if (biased >= 31) return sign | 0x7c00;
  if (biased < -10) return sign;
  // A subnormal half has its leading one explicit. A carry from rounding goes into the exponent, which is the correct next number.
  const full = biased > 0 ? (biased << 23) | mantissa : (mantissa | 0x800000) >>> 0;
  const shift = biased > 0 ? 13 : 14 - biased;
  const kept = full >>> shift;
  const rest = full & ((1 << shift) - 1);
  const tie = 1 << (shift - 1);
  return sign | (kept + (rest > tie || (rest === tie && kept & 1) ? 1 : 0));
}

/** The unit in the last place by the exponent's bits; those of subnormal halves have that of the smallest normal ones. */
const UNITS = Float64Array.from({ length: 31 }, (_, exponent) => 2 ** (Math.max(exponent, 1) - 25));

export function fromHalf(bits: number): number {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const mantissa = bits & 0x3ff;
  if (exponent === 31) return mantissa ? Number.NaN : sign * Number.POSITIVE_INFINITY;
  return sign * (exponent === 0 ? mantissa : mantissa | 0x400) * UNITS[exponent];
}
