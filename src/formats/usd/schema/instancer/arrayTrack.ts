import { IDENTITY, normalizeQuat, type Quat, slerp } from '../../../../math/quat.ts';
import { numbersOf } from '../../layer/attributes.ts';
import type { AttributeSpec, NumberArray } from '../../layer/layer.ts';

const NONE = new Float64Array(0);

/** An array attribute with one element per instance, read element by element: arrays are long, and instances many. */
export class ArrayTrack {
  /** Time codes of its samples, also of a single one; empty where it has none. */
  readonly times: Float64Array;
  private readonly values: readonly (NumberArray | undefined)[];
  private readonly width: number;

  constructor(attribute: AttributeSpec | undefined, width: number) {
    const samples = attribute?.timeSamples;
    this.width = width;
    this.times = samples ? samples.times : NONE;
    this.values = samples && samples.times.length > 0 ? samples.values.map(numbersOf) : [numbersOf(attribute?.value)];
  }

  /** How many elements there are at the last sample before a time, or the first; undefined without a value. */
  countAt(time: number): number | undefined {
    const held = this.values[this.lower(time)];
    return held && held.length / this.width;
  }

  /** The samples round a time; the same twice where there is only one, or none beyond. */
  around(time: number): readonly [from: number, to: number] {
    const k = this.lower(time);
    const isBefore = time < this.times[k];
    return [this.times[k], this.times[isBefore ? k : Math.min(k + 1, this.times.length - 1)]];
  }

  /** Element i at the last sample before a time. */
  held(i: number, time: number): readonly number[] {
    return this.element(this.values[this.lower(time)], i);
  }

  /** Element i between two samples of as many elements, else at the one before. */
  blended(i: number, time: number): readonly number[] {
    const [a, b, s] = this.neighbours(i, time);
    return b ? a.map((x, k) => x + s * (b[k] - x)) : a;
  }

  /** The same of quaternions, unit, along the shorter arc. */
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

  /** The last sample at or before a time; 0 before all. */
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

/** Normalizes: half-precision quaternions are unit to 10⁻³ only, and no shear is meant; zero is the identity. */
function unit([x, y, z, w]: readonly number[]): Quat {
  return Math.hypot(x, y, z, w) > 0 ? normalizeQuat([x, y, z, w]) : IDENTITY;
}
