import { Break, If, int, Loop } from 'three/tsl';
import type { Bool, Int } from '../types.ts';

/** 2^12 = 4096: the longest table that is searched to the end. */
const STEPS = 12;

/**
 * The last index at which `before` holds, where it holds up to some index and not after; 0 where it holds nowhere, count − 2 where it
 * holds everywhere, so that index and index + 1 always bound a piece. 2 ≤ `count` ≤ 4096.
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
