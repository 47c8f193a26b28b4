// Fixed-point numbers with 1024 fractional bits: an independent route to expected values, without cancellation.

export type Big = bigint;
const BITS = 1024n;

/** The exact value of a finite double (down to 2^-1024). */
export function big(x: number): Big {
  if (!Number.isFinite(x)) throw new RangeError(`${x} is no finite number`);
  let exponent = 0;
  let mantissa = x;
  // Scaling by two is exact, so the mantissa becomes an integer without rounding.
  while (!Number.isInteger(mantissa)) {
    mantissa *= 2;
    exponent--;
  }
  return (BigInt(mantissa) << BITS) >> BigInt(-exponent);
}

export const mul = (a: Big, b: Big): Big => (a * b) >> BITS;
export const div = (a: Big, b: Big): Big => (a << BITS) / b;

export function sqrt(a: Big): Big {
  const n = a << BITS;
  if (n <= 0n) return 0n;
  let x = 1n << BigInt((n.toString(2).length + 1) >> 1);
  for (;;) {
    const y = (x + n / x) >> 1n;
    if (y >= x) return x;
    x = y;
  }
}

export function toNumber(a: Big): number {
  const magnitude = a < 0n ? -a : a;
  const drop = Math.max(0, magnitude.toString(2).length - 100);
  const value = Number(magnitude >> BigInt(drop)) * 2 ** (drop - 512) * 2 ** (512 - Number(BITS));
  return a < 0n ? -value : value;
}

export type BigVec = readonly Big[];
export const bigVec = (v: readonly number[]): BigVec => v.map(big);
export const dotBig = (a: BigVec, b: BigVec): Big => a.reduce((sum, x, i) => sum + mul(x, b[i]), 0n);
export const lengthBig = (a: BigVec): Big => sqrt(dotBig(a, a));
export const ONE: Big = 1n << BITS;
