import { Break, If, int, Loop } from 'three/tsl';
import type { Bool, Int } from '../types.ts';

/** Enough for 2¹² = 4096 samples. */
const STEPS = 12;

/**
 * By bisection, the last index at which `before` is true, given that it is true up to some index and false after it; 0 if it is never true, count − 2 if
 * it is always true, so that index and index + 1 always bound a piece. 2 ≤ `count` ≤ 4096.
 */
export function bisect(count: Int, before: (index: Int) => Bool): Int {
  const low = int(0).toVar();
  const high = count.sub(1).toVar();
  Loop({ start: int(0), end: int(STEPS), type: 'int', condition: '<' }, () => {
    If(high.sub(low).lessThanEqual(1), () => {
      Break();
    });
    const middle = low.add(high).shiftRight(int(1)).toVar();
    If(before(middle), () => {
      low.assign(middle);
    }).Else(() => {
      high.assign(middle);
    });
  });
  return low;
}
