import { float, If, int, select, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import { MOST_LEVEL } from './leaf.ts';
import { STEPS } from './pattern.ts';

/** A leaf as shaders have it: its first eight floats, the place of its instance among all, and its edges' levels as packLevels made them. */
export interface ShaderLeaf {
  readonly head: Vec4;
  readonly tail: Vec4;
  readonly instance: Float;
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
 * Weights of the triangle's corners at the place (i, j) of a leaf's pattern (pattern.ts). A place on an edge that has fewer pieces than the
 * pattern goes to one of the edge's own. Exact on edges: weights are multiples of 2^−20 and places of 2^−4.
 */
export function weightsAt({ head, tail, levels }: Omit<ShaderLeaf, 'instance'>, i: Float, j: Float): Vec3 {
  const [l01, l12, l20] = [0, 3, 6].map((shift) => levels.shiftRight(int(shift)).bitAnd(int(7)).toVar());
  const [w0, w1, w2] = cornerWeights(head, tail);
  // As apexOf.
  const first = l01.lessThanEqual(l12).and(l01.lessThanEqual(l20)).toVar();
  const next = l12.lessThanEqual(l20).toVar();
  const turned = <T extends 'int' | 'vec3'>(at0: Node<T>, at1: Node<T>, at2: Node<T>) =>
    select(first, at2, select(next, at0, at1)) as Node<T>;
  const base = patternBase(l01, l12, l20);
  const c1 = i.toVar();
  const c2 = j.toVar();
  If(j.equal(0), () => {
    c1.assign(snapped(i, turned(l01, l12, l20), base));
  })
    .ElseIf(i.equal(0), () => {
      const second = turned(l20, l01, l12).toVar();
      const round = float(STEPS).sub(snapped(float(STEPS).sub(j), second, base));
      c2.assign(select(base.equal(greater(greater(l01, l12), l20)), round, snapped(j, second, base)));
    })
    .ElseIf(i.add(j).equal(STEPS), () => {
      c2.assign(snapped(j, turned(l12, l20, l01), base));
      c1.assign(float(STEPS).sub(c2));
    });
  const [b, c] = [c1.mul(1 / STEPS).toVar(), c2.mul(1 / STEPS).toVar()];
  return turned(w0, w1, w2)
    .mul(b.add(c).oneMinus())
    .add(turned(w1, w2, w0).mul(b))
    .add(turned(w2, w0, w1).mul(c))
    .toVar();
}

/** As baseOf (pattern.ts). */
export function patternBase(l01: Int, l12: Int, l20: Int): Int {
  const least = lesser(lesser(l01, l12), l20);
  const most = greater(greater(l01, l12), l20);
  const middle = l01.add(l12).add(l20).sub(least).sub(most).toVar();
  const base = least.add(int(1)).add(most).sub(middle).toVar();
  return select(base.lessThan(most).and(base.lessThanEqual(middle)), base, most).toVar();
}

// TSL's own are for floats only.
export const greater = (a: Int, b: Int): Int => select(a.greaterThan(b), a, b).toVar();
const lesser = (a: Int, b: Int): Int => select(a.lessThan(b), a, b).toVar();

/** As its namesake in pattern.ts. */
function snapped(k: Float, level: Int, base: Int): Float {
  const shift = int(MOST_LEVEL).sub(level).toVar();
  const step = int(1).shiftLeft(shift).toVar();
  const width = int(STEPS).shiftRight(base).toVar();
  const single = k.lessThanEqual(float(width)).and(step.lessThanEqual(width));
  const up = step.sub(int(1));
  const half = up.shiftRight(int(1));
  return float(
    int(k)
      .add(select(single, up, half))
      .shiftRight(shift)
      .shiftLeft(shift),
  );
}
