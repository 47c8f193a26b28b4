/** A position in a pixel relative to its centre, right and down [px]: −½ … ½. */
export type SamplePosition = readonly [x: number, y: number];
export const PIXEL_CENTER: SamplePosition = [0, 0];

/** Number of pictures after which the sequence repeats. */
const HALTON_PERIOD = 16;

/** The sample position of picture `frame`: successive positions are spread evenly. Source: Halton 1960, bases 2 and 3. */
export const haltonPosition = (frame: number): SamplePosition => {
  const index = (frame % HALTON_PERIOD) + 1;
  return [radicalInverse(index, 2) - 0.5, radicalInverse(index, 3) - 0.5];
};

/** The digits of an integer mirrored at the radix point: 0 … 1. */
function radicalInverse(index: number, base: number): number {
  let [value, digitValue] = [0, 1 / base];
  for (let rest = index; rest > 0; rest = Math.floor(rest / base)) {
    value += digitValue * (rest % base);
    digitValue /= base;
  }
  return value;
}

/** The n × n positions of a regular grid in a pixel; if n is a power of two, ordered so that the first 4, 16, … form a regular grid too. */
export function gridPositions(n: number): readonly SamplePosition[] {
  const cells = Array.from({ length: n * n }, (_, i) => [i % n, Math.floor(i / n)] as const);
  const center = (cell: number): number => (cell + 0.5) / n - 0.5;
  return cells
    .map(([x, y]) => ({ key: reversedBits(x) + reversedBits(x ^ y) / 2, position: [center(x), center(y)] as const }))
    .sort((a, b) => a.key - b.key)
    .map(({ position }) => position);
}

/** The binary digits of a cell index mirrored at the point, with a zero inserted after each: 0 … 1. */
function reversedBits(cell: number): number {
  let [value, digitValue] = [0, 1 / 2];
  for (let rest = cell; rest > 0; rest >>= 1) {
    value += digitValue * (rest & 1);
    digitValue /= 4;
  }
  return value;
}
