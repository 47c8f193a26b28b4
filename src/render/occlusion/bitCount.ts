import { float, uint } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float } from '../../shaders/types.ts';

export type Bitmask = Node<'uint'>;

/** Number of bits that are set. WebGL2 has no built-in function for it. Source: Warren 2012, "Hacker's Delight", fig. 5-2. */
export function countBits(bits: Bitmask): Float {
  const pairs = bits.sub(bits.shiftRight(uint(1)).bitAnd(uint(0x55555555))).toVar();
  const fours = pairs
    .bitAnd(uint(0x33333333))
    .add(pairs.shiftRight(uint(2)).bitAnd(uint(0x33333333)))
    .toVar();
  const bytes = fours.add(fours.shiftRight(uint(4))).bitAnd(uint(0x0f0f0f0f));
  return float(bytes.mul(uint(0x01010101)).shiftRight(uint(24)));
}
