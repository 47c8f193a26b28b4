/** A place in a pixel, from its centre, right and down [px]: −½ … ½. */
export type SamplePosition = readonly [x: number, y: number];
export const PIXEL_CENTER: SamplePosition = [0, 0];

/** Pictures after which the places of single samples begin anew. */
const HALTON_PERIOD = 16;

/** Where in its pixels the picture of this number has its samples: any few in a row are spread evenly. Source: Halton 1960, bases 2 and 3. */
export const haltonPosition = (frame: number): SamplePosition => {
  const index = (frame % HALTON_PERIOD) + 1;
  return [radicalInverse(index, 2) - 0.5, radicalInverse(index, 3) - 0.5];
};

/** The digits of a whole number mirrored at the point: 0 … 1. */
function radicalInverse(index: number, base: number): number {
  let [value, share] = [0, 1 / base];
  for (let rest = index; rest > 0; rest = Math.floor(rest / base)) {
    value += share * (rest % base);
    share /= base;
  }
  return value;
}

/** The n × n places of an even grid in a pixel, in an order in which the first 4, 16, … of a power of two are themselves spread evenly. */
export function gridPositions(n: number): readonly SamplePosition[] {
  const cells = Array.from({ length: n * n }, (_, i) => [i % n, Math.floor(i / n)] as const);
  const center = (cell: number): number => (cell + 0.5) / n - 0.5;
  return cells
    .map(([x, y]) => ({ key: reversedBits(x) + reversedBits(x ^ y) / 2, place: [center(x), center(y)] as const }))
    .sort((a, b) => a.key - b.key)
    .map(({ place }) => place);
}

/** The binary digits of a cell mirrored, with a place free behind each: 0 … 1. */
function reversedBits(cell: number): number {
  let [value, share] = [0, 1 / 2];
  for (let rest = cell; rest > 0; rest >>= 1) {
    value += share * (rest & 1);
    share /= 4;
  }
  return value;
}
