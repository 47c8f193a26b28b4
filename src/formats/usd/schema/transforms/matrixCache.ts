import type { Mat4 } from '../../../../math/mat4.ts';

/** Maximum number of slots, 1 MB. */
const MAX_MATRICES = 2 ** 13;
/** Slots per expected time, so that collisions are rare. */
const SLOTS_PER_TIME = 8;

/** Direct-mapped cache of matrices by time: each time has one slot, by a hash of its bits. */
export class MatrixCache {
  private readonly mask: number;
  private readonly times: Float64Array;
  private readonly matrices: Float64Array;
  private readonly bits = new Float64Array(1);
  private readonly words = new Uint32Array(this.bits.buffer);

  /** `times`: expected number of different times. */
  constructor(times: number) {
    const slots = Math.min(MAX_MATRICES, 2 ** Math.ceil(Math.log2(SLOTS_PER_TIME * Math.max(1, times))));
    this.mask = slots - 1;
    this.times = new Float64Array(slots).fill(Number.NaN);
    this.matrices = new Float64Array(16 * slots);
  }

  /** The cached matrix of a time, or that of `make`. */
  getOrCompute(time: number, make: (time: number) => Mat4): Mat4 {
    const slot = this.slotOf(time);
    const { matrices: m } = this;
    const i = 16 * slot;
    if (this.times[slot] === time) {
      const upper = [m[i], m[i + 1], m[i + 2], m[i + 3], m[i + 4], m[i + 5], m[i + 6], m[i + 7]] as const;
      return [...upper, m[i + 8], m[i + 9], m[i + 10], m[i + 11], m[i + 12], m[i + 13], m[i + 14], m[i + 15]];
    }
    const made = make(time);
    this.times[slot] = time;
    for (let k = 0; k < 16; k++) m[i + k] = made[k];
    return made;
  }

  /** Fibonacci hashing (Knuth 1973, The Art of Computer Programming 3, §6.4). */
  private slotOf(time: number): number {
    this.bits[0] = time;
    const hash = Math.imul(this.words[0] ^ Math.imul(this.words[1], 0x9e3779b1), 0x9e3779b1);
    return (hash ^ (hash >>> 15)) & this.mask;
  }
}
