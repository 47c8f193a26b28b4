type Held = Float32Array | Int32Array;

/** Numbers of a count that is not known before; a few are pushed at a time. */
class Growing<T extends Held> {
  #held: T;
  #length = 0;
  readonly #make: (length: number) => T;
  constructor(make: (length: number) => T) {
    this.#make = make;
    this.#held = make(1024);
  }

  get length(): number {
    return this.#length;
  }

  push(a: number, b?: number, c?: number): void {
    if (this.#length + 3 > this.#held.length) this.#grow();
    this.#held[this.#length++] = a;
    if (b !== undefined) this.#held[this.#length++] = b;
    if (c !== undefined) this.#held[this.#length++] = c;
  }

  /** What there is now; later pushes may or may not show in it. */
  values(): T {
    return this.#held.subarray(0, this.#length) as T;
  }

  #grow(): void {
    const larger = this.#make(2 * this.#held.length);
    larger.set(this.#held);
    this.#held = larger;
  }
}

export type Floats = Growing<Float32Array>;
export type Integers = Growing<Int32Array>;
/** In single precision. */
export const growingFloats = (): Floats => new Growing((length) => new Float32Array(length));
/** −2³¹ … 2³¹ − 1. */
export const growingIntegers = (): Integers => new Growing((length) => new Int32Array(length));
