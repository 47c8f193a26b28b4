import { IDENTITY, normalizeQuat, type Quat, slerp } from '../../../../math/quat.ts';
import { numbersOf } from '../../layer/attributes.ts';
import type { AttributeSpec, NumberArray } from '../../layer/layer.ts';

const NONE = new Float64Array(0);

/** An array attribute with one element per instance, evaluated per element to avoid copies of long arrays. */
export class ArrayTrack {
  /** Time codes of its samples, also of a single one; empty if there are none. */
  readonly times: Float64Array;
  private readonly values: readonly (NumberArray | undefined)[];
  private readonly width: number;

  constructor(attribute: AttributeSpec | undefined, width: number) {
    const samples = attribute?.timeSamples;
    this.width = width;
    this.times = samples ? samples.times : NONE;
    this.values = samples && samples.times.length > 0 ? samples.values.map(numbersOf) : [numbersOf(attribute?.value)];
  }

  /** Number of elements of the last sample before a time, or of the first; undefined without a value. */
  countAt(time: number): number | undefined {
    const held = this.values[this.lower(time)];
    return held && held.length / this.width;
  }

  /** The samples around a time; the same twice if there is only one, or none beyond. */
  around(time: number): readonly [from: number, to: number] {
    const k = this.lower(time);
    const isBefore = time < this.times[k];
    return [this.times[k], this.times[isBefore ? k : Math.min(k + 1, this.times.length - 1)]];
  }

  /** Element i at the last sample before a time. */
  held(i: number, time: number): readonly number[] {
    return this.element(this.values[this.lower(time)], i);
  }

  /** Element i interpolated linearly, or held if the two samples have different lengths. */
  blended(i: number, time: number): readonly number[] {
    const [a, b, s] = this.neighbours(i, time);
    return b ? a.map((x, k) => x + s * (b[k] - x)) : a;
  }

  /** Quaternion i interpolated along the shorter arc; unit. */
  slerped(i: number, time: number): Quat {
    const [a, b, s] = this.neighbours(i, time);
    return b ? slerp(unit(a), unit(b), s) : unit(a);
  }

  heldQuaternion(i: number, time: number): Quat {
    return unit(this.held(i, time));
  }

  private neighbours(i: number, time: number): [number[], number[] | undefined, number] {
    const k = this.lower(time);
    const [a, b] = [this.values[k], this.values[k + 1]];
    const from = this.element(a, i);
    if (!b || b.length !== a?.length || !(time > this.times[k])) return [from, undefined, 0];
    return [from, this.element(b, i), (time - this.times[k]) / (this.times[k + 1] - this.times[k])];
  }

  private element(values: NumberArray | undefined, i: number): number[] {
    return Array.from({ length: this.width }, (_, k) => values?.[this.width * i + k] ?? 0);
  }

  /** Index of the last sample at or before a time; 0 before the first. */
  private lower(time: number): number {
    let low = 0;
    let high = this.times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) low = middle;
      else high = middle;
    }
    return low;
  }
}

/** Normalizes a quaternion: half-precision ones are unit only to 10⁻³. Zero becomes the identity. */
function unit([x, y, z, w]: readonly number[]): Quat {
  return Math.hypot(x, y, z, w) > 0 ? normalizeQuat([x, y, z, w]) : IDENTITY;
}
