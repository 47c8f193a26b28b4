import { readStoredNumbers, type StoredNumbers, type StoredSample } from '../../../scene/streaming/storedNumbers.ts';
import { lowerSample, numbersOf } from './attributes.ts';
import type { AttributeSpec, NumberArray, TupleType, Value } from './layer.ts';

/** An array left on disk, usable as any other value; each access to `data` reads it. */
export class StoredArray {
  readonly type: `${TupleType}[]`;
  readonly numbers: StoredNumbers;

  constructor(type: `${TupleType}[]`, numbers: StoredNumbers) {
    this.type = type;
    this.numbers = numbers;
  }

  get data(): NumberArray {
    return readStoredNumbers(this.numbers);
  }
}

/** Length of a value in numbers, without reading it. */
export const countOf = (value: Value): number | undefined =>
  value instanceof StoredArray ? value.numbers.count : numbersOf(value)?.length;

/** The stored arrays behind an attribute's values at the given times, if all are stored; nothing is read. */
export function storedSamples(attribute: AttributeSpec | undefined): ((time: number) => StoredSample) | undefined {
  const { times, values } = attribute?.timeSamples ?? { times: new Float64Array(0), values: [] };
  const stored = values.filter((value) => value instanceof StoredArray);
  if (stored.length === 0 || stored.length < values.length) return undefined;
  return (time) => {
    const i = lowerSample(times, time);
    const [a, b] = [stored[i], stored[i + 1]];
    if (!b || time <= times[i] || a.type !== b.type) return { before: a.numbers, fraction: 0 };
    return { before: a.numbers, after: b.numbers, fraction: (time - times[i]) / (times[i + 1] - times[i]) };
  };
}
