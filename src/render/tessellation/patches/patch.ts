/**
 * A leaf: a triangle of the mesh, or a part of one, as nine floats.
 *   0      triangle, by its place in the batch's indices / 3
 *   1 … 6  w0.1, w0.2, w1.1, w1.2, w2.1, w2.2: weights of the triangle's second and third corner at the leaf's corners 0, 1, 2
 *          (the first has what is left of 1), multiples of 2^−MOST_HALVINGS and so exact in f32, as all their sums are
 *   7      levels of the edges 0–1, 1–2 and 2–0 (`packFactors`); 0 where they are not known yet
 *   8      where many wear the mesh, whose it is: its place among the bodies of the batch
 */
export const PATCH_FLOATS = 9;
export const FACTORS_OFFSET = 7;
export const INSTANCE_OFFSET = 8;
/** An edge of level L has 2^L pieces. */
export const MAX_LOG2_FACTOR = 4;
/** How often an edge of the mesh can be halved before its leaves' levels. */
export const MAX_SUBDIVISIONS = 20;

/** The levels of a leaf's edges as one number that is exact in f32. */
export const packFactors = (f01: number, f12: number, f20: number): number => f01 + 8 * f12 + 64 * f20;

/** A list of leaves that grows. */
export class PatchList {
  private floats: Float32Array<ArrayBuffer>;
  private used = 0;

  constructor(room = 256) {
    this.floats = new Float32Array(PATCH_FLOATS * room);
  }

  get count(): number {
    return this.used;
  }
  /** Valid until the next `add` or `clear`. */
  get patches(): Float32Array<ArrayBuffer> {
    return this.floats.subarray(0, PATCH_FLOATS * this.used);
  }

  clear(): void {
    this.truncate(0);
  }
  /** Forgets all but the first. */
  truncate(count: number): void {
    this.used = count;
  }

  /** A part of a triangle: a, b, c are the places of its corners in `points` (projectedBody.ts). */
  add(triangle: number, points: Float64Array, a: number, b: number, c: number, wearer = 0): void {
    const at = this.next();
    const out = this.floats;
    out[at] = triangle;
    out[at + 1] = points[a + 6];
    out[at + 2] = points[a + 7];
    out[at + 3] = points[b + 6];
    out[at + 4] = points[b + 7];
    out[at + 5] = points[c + 6];
    out[at + 6] = points[c + 7];
    out[at + FACTORS_OFFSET] = 0;
    out[at + INSTANCE_OFFSET] = wearer;
  }

  /** A leaf of another list, with its levels. */
  copy(from: Float32Array, leaf: number, levels: number): void {
    const at = this.next();
    for (let k = 0; k < PATCH_FLOATS; k++) this.floats[at + k] = from[PATCH_FLOATS * leaf + k];
    this.floats[at + FACTORS_OFFSET] = levels;
  }

  private next(): number {
    if (PATCH_FLOATS * (this.used + 1) > this.floats.length) {
      const grown = new Float32Array(2 * this.floats.length);
      grown.set(this.floats);
      this.floats = grown;
    }
    return PATCH_FLOATS * this.used++;
  }
}
