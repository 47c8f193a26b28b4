import type { Random } from '../../math/random.ts';

/**
 * Low-discrepancy random numbers for the samples of a pixel: the numbers 2k and 2k + 1 of the samples 0, 1, 2 … form an Owen-scrambled
 * Sobol' sequence in the plane, so that any 2ᵐ samples from a multiple of 2ᵐ on have one point in every box of area 2⁻ᵐ whose sides are
 * powers of two; the pairs are shuffled independently of each other. Errors fall faster than 1/√N.
 * Source: Burley 2020, "Practical hash-based Owen scrambling", JCGT 9(4).
 */
export function pixelSequence(seed: number, x: number, y: number): (sample: number) => Random {
  const pixel = hash(hash(hash(0, seed), x), y);
  return (sample) => {
    let used = 0;
    let index = 0;
    return () => {
      const pair = hash(pixel, used >>> 1);
      const second = used++ & 1;
      if (!second) index = scramble(sample, pair);
      return scramble(second ? sobol(index) : reverse(index), hash(pair, 1 + second)) / 2 ** 32;
    };
  };
}

/** The second dimension of Sobol's sequence, whose direction numbers are Pascal's triangle modulo 2; the first is the bit reversal. */
function sobol(index: number): number {
  let [rest, direction, sum] = [index, 1 << 31, 0];
  for (; rest !== 0; rest >>>= 1, direction ^= direction >>> 1) if (rest & 1) sum ^= direction;
  return sum >>> 0;
}

/** Owen scrambling: randomly swaps the halves of the unit interval, of each half, of each quarter … */
const scramble = (x: number, seed: number): number => reverse(mixUpwards(reverse(x), seed));

/** A hash in which each bit affects only itself and higher bits. Source: Laine & Karras 2011, "Stratified sampling for stochastic transparency". */
function mixUpwards(x: number, seed: number): number {
  let v = (x + seed) | 0;
  v ^= Math.imul(v, 0x6c50b47c);
  v ^= Math.imul(v, 0xb82f1e52);
  v ^= Math.imul(v, 0xc7afe638);
  return v ^ Math.imul(v, 0x8d22f6e6);
}

function reverse(x: number): number {
  let v = ((x >>> 1) & 0x55555555) | ((x & 0x55555555) << 1);
  v = ((v >>> 2) & 0x33333333) | ((v & 0x33333333) << 2);
  v = ((v >>> 4) & 0x0f0f0f0f) | ((v & 0x0f0f0f0f) << 4);
  v = ((v >>> 8) & 0x00ff00ff) | ((v & 0x00ff00ff) << 8);
  return ((v >>> 16) | (v << 16)) >>> 0;
}

/** Hashes two numbers into one whose bits all depend on all of theirs. Source: the finalizer of MurmurHash3 (Appleby). */
function hash(a: number, b: number): number {
  let v = Math.imul(a ^ Math.imul(b | 0, 0x9e3779b1), 0x85ebca6b) + 0x7f4a7c15;
  v = Math.imul(v ^ (v >>> 16), 0x85ebca6b);
  v = Math.imul(v ^ (v >>> 13), 0xc2b2ae35);
  return (v ^ (v >>> 16)) >>> 0;
}
