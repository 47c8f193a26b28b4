import { If, int, vec3 } from 'three/tsl';
import type { Int, Vec3, Vec4 } from '../../shaders/types.ts';
import { MOST_LEVEL } from './leaf.ts';

/** Places in a pattern count in pieces of the finest one, so that levels can be compared. */
export const STEPS = 1 << MOST_LEVEL;

/** A leaf as shaders have it: its eight floats, and its edges' levels as packLevels made them. */
export interface ShaderLeaf {
  readonly head: Vec4;
  readonly tail: Vec4;
  readonly levels: Int;
}

/** Weights of the triangle's three corners at the leaf's three; `head`, `tail`: the leaf's eight floats. */
export const cornerWeights = (head: Vec4, tail: Vec4): readonly [Vec3, Vec3, Vec3] => [
  whole(head.y, head.z),
  whole(head.w, tail.x),
  whole(tail.y, tail.z),
];

const whole = (second: Vec4['x'], third: Vec4['x']): Vec3 => vec3(second.oneMinus().sub(third), second, third);

/**
 * Weights of the triangle's corners at the place (i, j) of a leaf's pattern, in pieces of the finest one.
 * A place on an edge that has fewer pieces than the pattern goes to one of the edge's own (pattern.ts).
 * Exact: weights are multiples of 2^−20 and places of 2^−4.
 */
export function weightsAt({ head, tail, levels }: ShaderLeaf, i: Int, j: Int): Vec3 {
  const c1 = i.toVar();
  const c2 = j.toVar();
  const c0 = int(STEPS).sub(i).sub(j).toVar();
  const snap = (from: Int, to: Int, edge: Int): void => {
    const shift = int(MOST_LEVEL)
      .sub(edge.bitAnd(int(7)))
      .toVar();
    const half = int(1).shiftLeft(shift).sub(int(1)).shiftRight(int(1));
    to.assign(to.add(half).shiftRight(shift).shiftLeft(shift));
    from.assign(int(STEPS).sub(to));
  };
  If(c2.equal(int(0)), () => snap(c0, c1, levels))
    .ElseIf(c0.equal(int(0)), () => snap(c1, c2, levels.shiftRight(int(3))))
    .ElseIf(c1.equal(int(0)), () => snap(c2, c0, levels.shiftRight(int(6))));
  const share = vec3(c0, c1, c2)
    .mul(1 / STEPS)
    .toVar();
  const [w0, w1, w2] = cornerWeights(head, tail);
  return w0.mul(share.x).add(w1.mul(share.y)).add(w2.mul(share.z)).toVar();
}
