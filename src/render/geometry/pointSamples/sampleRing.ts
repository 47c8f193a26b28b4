/** Number of samples that are requested before they are needed. */
const PREFETCH = 8;

/** The samples to load for a frame. */
export interface RingRequest {
  /** Samples of the frame's window that are not resident. */
  readonly missing: readonly number[];
  /** The next samples in the direction of play that are not resident, nearest first. */
  readonly prefetch: readonly number[];
}

/** Which samples of a long motion are resident in a ring buffer: sample k is in slot k mod capacity, where it replaces another one. */
export class SampleRing {
  private readonly resident: Int32Array;
  private readonly length: number;
  /** Direction in which the window last moved: 1 or −1. */
  private direction = 1;
  /** All requested samples are in [first, end). */
  first = 0;
  end = 0;
  private previousFirst = 0;

  /** `length`: number of samples of the motion. */
  constructor(capacity: number, length: number) {
    this.resident = new Int32Array(capacity).fill(-1);
    this.length = length;
  }

  /** The samples that a frame with samples [first, first + count) needs; at most as many as there are slots. */
  request(first: number, count: number): RingRequest {
    if (first !== this.previousFirst) this.direction = Math.sign(first - this.previousFirst);
    this.previousFirst = first;
    const spare = Math.min(PREFETCH, this.resident.length - count);
    this.first = this.direction < 0 ? Math.max(0, first - spare) : first;
    this.end = this.direction > 0 ? Math.min(this.length, first + count + spare) : first + count;
    const prefetch = [...this.missing(this.first, first).reverse(), ...this.missing(first + count, this.end)];
    return { missing: this.missing(first, first + count), prefetch };
  }

  /** Records that sample k is in its slot. */
  markResident(k: number): void {
    this.resident[k % this.resident.length] = k;
  }

  private missing(first: number, end: number): number[] {
    const { resident } = this;
    return Array.from({ length: Math.max(0, end - first) }, (_, i) => first + i).filter(
      (k) => resident[k % resident.length] !== k,
    );
  }
}
