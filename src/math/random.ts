/** The next number of a sequence, uniform in [0, 1). */
export type Random = () => number;

/**
 * A seeded generator of numbers in [0, 1), with the same sequence on every machine: sfc32 of PractRand (Doty-Humphrey), 2³² seeds
 * with periods of at least 2³².
 * @example
 * const next = random(42);
 * const again = random(42);
 * next() === again(); // true
 */
export function random(seed: number): Random {
  let [a, b, c, counter] = [0, seed | 0, seed ^ 0x9e3779b9, 1];
  const next = () => {
    const t = (a + b + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (((c << 21) | (c >>> 11)) + t) | 0;
    return (t >>> 0) / 2 ** 32;
  };
  for (let i = 0; i < 15; i++) next();
  return next;
}
