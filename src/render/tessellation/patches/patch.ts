/**
 * Layout of a patch: a triangle of the mesh, or a part of one, as nine floats.
 *   0      triangle: its first index in the batch / 3
 *   1 … 6  w0.1, w0.2, w1.1, w1.2, w2.1, w2.2: weights of the triangle's second and third corner at the patch's corners 0, 1, 2 (the first corner has the
 *          rest to 1); they are multiples of 2^−MAX_SUBDIVISIONS, so they and all their sums are exact in f32
 *   7      tessellation factors of the edges 0–1, 1–2 and 2–0 (`packFactors`); 0 until they are computed
 *   8      with instancing, the index of the body among the bodies of the batch
 */
export const PATCH_FLOATS = 9;
export const FACTORS_OFFSET = 7;
export const INSTANCE_OFFSET = 8;
/** An edge has at most 2^4 segments; factors are stored as exponents. */
export const MAX_LOG2_FACTOR = 4;
/** How often an edge of the mesh can be halved before the factors of its patches apply. */
export const MAX_SUBDIVISIONS = 20;

/** The tessellation factors of a patch's edges as one number that is exact in f32. */
export const packFactors = (f01: number, f12: number, f20: number): number => f01 + 8 * f12 + 64 * f20;

/** A growing list of patches. */
export class PatchList {
  private floats: Float32Array<ArrayBuffer>;
  private used = 0;

  constructor(capacity = 256) {
    this.floats = new Float32Array(PATCH_FLOATS * capacity);
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
  /** Discards all but the first `count`. */
  truncate(count: number): void {
    this.used = count;
  }

  /** Adds a part of a triangle: a, b, c are the indices of its corners in `points` (projectedBody.ts). */
  add(triangle: number, points: Float64Array, a: number, b: number, c: number, instance = 0): void {
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
    out[at + INSTANCE_OFFSET] = instance;
  }

  /** Adds a patch of another list, with its factors. */
  copy(from: Float32Array, index: number, factors: number): void {
    const at = this.next();
    for (let k = 0; k < PATCH_FLOATS; k++) this.floats[at + k] = from[PATCH_FLOATS * index + k];
    this.floats[at + FACTORS_OFFSET] = factors;
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
