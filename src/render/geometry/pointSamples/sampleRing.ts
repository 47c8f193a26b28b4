/** So many samples are asked for before they are needed. */
const PREFETCH = 8;

/** What a picture wants. */
export interface RingRequest {
  /** Of its own samples, those that are not held. */
  readonly missing: readonly number[];
  /** Those that come next the way the play goes, not held either: the nearest first. */
  readonly prefetch: readonly number[];
}

/** Which samples of a long motion are held in a ring of places: sample k in place k mod capacity, where it pushes out another one. */
export class SampleRing {
  private readonly held: Int32Array;
  private readonly length: number;
  /** The way that the window went last: 1 or −1. */
  private direction = 1;
  /** All that is wanted is in [first, end). */
  first = 0;
  end = 0;
  private previousFirst = 0;

  /** `length`: of the motion. */
  constructor(capacity: number, length: number) {
    this.held = new Int32Array(capacity).fill(-1);
    this.length = length;
  }

  /** What a picture of samples [first, first + count) wants; at most as many as there are places. */
  request(first: number, count: number): RingRequest {
    if (first !== this.previousFirst) this.direction = Math.sign(first - this.previousFirst);
    this.previousFirst = first;
    const spare = Math.min(PREFETCH, this.held.length - count);
    this.first = this.direction < 0 ? Math.max(0, first - spare) : first;
    this.end = this.direction > 0 ? Math.min(this.length, first + count + spare) : first + count;
    const ahead = [...this.missing(this.first, first).reverse(), ...this.missing(first + count, this.end)];
    return { missing: this.missing(first, first + count), prefetch: ahead };
  }

  /** Says that sample k is in its place now. */
  markResident(k: number): void {
    this.held[k % this.held.length] = k;
  }

  private missing(first: number, end: number): number[] {
    const { held } = this;
    return Array.from({ length: Math.max(0, end - first) }, (_, i) => first + i).filter(
      (k) => held[k % held.length] !== k,
    );
  }
}
