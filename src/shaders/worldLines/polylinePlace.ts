import { clamp, int, select, vec4 } from 'three/tsl';
import type { Int, SampleTable, WorldLineAt } from '../types.ts';
import { bisect } from './bisect.ts';
import { pieceVelocity } from './pieceVelocity.ts';

/**
 * World line of a vertex that moves uniformly between samples (relative to the anchor) and is at rest outside them; 2 ≤ `count` ≤ 4096.
 * @example
 * import { float, int, select, vec4 } from 'three/tsl';
 * const samples = (i: Int) => select(i.equal(int(0)), vec4(0, 0, 0, -1), vec4(1, 0, 0, 1));
 * const { x } = polylinePlace(samples, int(2))(float(0.5));
 */
export const polylinePlace =
  (at: SampleTable, count: Int): WorldLineAt =>
  (time) => {
    const index = bisect(count, (i) => at(i).w.lessThanEqual(time));
    const a = at(index).toVar();
    const b = at(index.add(int(1))).toVar();
    const moving = pieceVelocity(a, b).toVar();
    const resting = time.lessThan(a.w).or(time.greaterThanEqual(b.w));
    const elapsed = clamp(time.sub(a.w), 0, b.w.sub(a.w));
    return {
      x: select(time.greaterThanEqual(b.w), b.xyz, a.xyz.add(moving.xyz.mul(elapsed))).toVar(),
      velocity: select(resting, vec4(0, 0, 0, 1), moving).toVar(),
    };
  };
