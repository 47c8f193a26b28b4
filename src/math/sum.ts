/** A compensated sum: `value` is the rounded sum, `rest` what rounding took from it. */
export interface Sum {
  readonly value: number;
  readonly rest: number;
}

/** The sum that is one number. */
export const sumOf = (value: number): Sum => ({ value, rest: 0 });

/** The sum and one number more: the error of the addition is found exactly. Knuth's TwoSum; The Art of Computer Programming, vol. 2, §4.2.2, theorem B. */
export function plus({ value, rest }: Sum, x: number): Sum {
  const sum = value + x;
  const part = sum - value;
  const error = value - (sum - part) + (x - part);
  const low = rest + error;
  const total = sum + low;
  return { value: total, rest: low - (total - sum) };
}
