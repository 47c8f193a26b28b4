import { clamp, int, select, vec4 } from 'three/tsl';
import type { Int, SampleTable, WorldLineAt } from '../types.ts';
import { bisect } from './bisect.ts';
import { cubicPiece, type EndVelocities, evaluateCubic } from './cubicPiece.ts';

/** World line of a vertex that moves along cubics between samples (relative to the anchor) and is at rest outside them; 2 ≤ `count` ≤ 4096. */
export const cubicPlace =
  (at: SampleTable, velocities: EndVelocities, count: Int): WorldLineAt =>
  (time) => {
    const index = bisect(count, (i) => at(i).w.lessThanEqual(time));
    const a = at(index).toVar();
    const b = at(index.add(int(1))).toVar();
    const piece = cubicPiece(a, b, velocities(index));
    const { x, velocity } = evaluateCubic(piece, clamp(time.sub(a.w), 0, piece.span).toVar());
    const resting = time.lessThan(a.w).or(time.greaterThanEqual(b.w));
    return {
      x: select(time.greaterThanEqual(b.w), b.xyz, x).toVar(),
      velocity: select(resting, vec4(0, 0, 0, 1), velocity).toVar(),
    };
  };
