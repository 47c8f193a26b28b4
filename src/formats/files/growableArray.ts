type GrowableNumbers = Float32Array | Int32Array;

/** A growable typed array, appended a few numbers at a time. */
class GrowableArray<T extends GrowableNumbers> {
  private held: T;
  private used = 0;
  private readonly make: (length: number) => T;
  constructor(make: (length: number) => T) {
    this.make = make;
    this.held = make(1024);
  }

  get length(): number {
    return this.used;
  }

  push(a: number, b?: number, c?: number): void {
    if (this.used + 3 > this.held.length) this.grow();
    this.held[this.used++] = a;
    if (b !== undefined) this.held[this.used++] = b;
    if (c !== undefined) this.held[this.used++] = c;
  }

  /** The current contents; later pushes may or may not show in it. */
  values(): T {
    return this.held.subarray(0, this.used) as T;
  }

  private grow(): void {
    const larger = this.make(2 * this.held.length);
    larger.set(this.held);
    this.held = larger;
  }
}

export type GrowableFloats = GrowableArray<Float32Array>;
export type GrowableIntegers = GrowableArray<Int32Array>;
/** In single precision. */
export const growableFloats = (): GrowableFloats => new GrowableArray((length) => new Float32Array(length));
/** −2³¹ … 2³¹ − 1. */
export const growableIntegers = (): GrowableIntegers => new GrowableArray((length) => new Int32Array(length));
