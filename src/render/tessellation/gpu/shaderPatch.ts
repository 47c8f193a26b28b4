import { float, If, int, select, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import { MAX_LOG2_FACTOR } from '../patches/patch.ts';
import { EDGE_STEPS } from '../patches/pattern.ts';

/** A patch in shaders: its first eight floats, the index of its instance, and the tessellation factors of its edges as by `packFactors`. */
export interface ShaderPatch {
  readonly head: Vec4;
  readonly tail: Vec4;
  readonly instance: Float;
  readonly factors: Int;
}

/** Weights of the triangle's three corners at the patch's three; `head`, `tail`: the patch's eight floats. */
export const cornerWeights = (head: Vec4, tail: Vec4): readonly [Vec3, Vec3, Vec3] => [
  barycentric(head.y, head.z),
  barycentric(head.w, tail.x),
  barycentric(tail.y, tail.z),
];

const barycentric = (second: Vec4['x'], third: Vec4['x']): Vec3 => vec3(second.oneMinus().sub(third), second, third);

/**
 * Weights of the triangle's corners at the place (i, j) of a patch's pattern (pattern.ts). A place on an edge with fewer segments than the pattern is snapped
 * to one of the edge's own. Exact on edges: weights are multiples of 2^−20, places of 2^−4.
 */
export function weightsAt({ head, tail, factors }: Omit<ShaderPatch, 'instance'>, i: Float, j: Float): Vec3 {
  const [l01, l12, l20] = [0, 3, 6].map((shift) => factors.shiftRight(int(shift)).bitAnd(int(7)).toVar());
  const [w0, w1, w2] = cornerWeights(head, tail);
  // See `apexOf` (pattern.ts).
  const first = l01.lessThanEqual(l12).and(l01.lessThanEqual(l20)).toVar();
  const next = l12.lessThanEqual(l20).toVar();
  const fromApex = <T extends 'int' | 'vec3'>(at0: Node<T>, at1: Node<T>, at2: Node<T>) =>
    select(first, at2, select(next, at0, at1)) as Node<T>;
  const base = baseFactor(l01, l12, l20);
  const c1 = i.toVar();
  const c2 = j.toVar();
  If(j.equal(0), () => {
    c1.assign(snapToEdge(i, fromApex(l01, l12, l20), base));
  })
    .ElseIf(i.equal(0), () => {
      const second = fromApex(l20, l01, l12).toVar();
      const snapped = float(EDGE_STEPS).sub(snapToEdge(float(EDGE_STEPS).sub(j), second, base));
      c2.assign(select(base.equal(maxInt(maxInt(l01, l12), l20)), snapped, snapToEdge(j, second, base)));
    })
    .ElseIf(i.add(j).equal(EDGE_STEPS), () => {
      c2.assign(snapToEdge(j, fromApex(l12, l20, l01), base));
      c1.assign(float(EDGE_STEPS).sub(c2));
    });
  const [b, c] = [c1.mul(1 / EDGE_STEPS).toVar(), c2.mul(1 / EDGE_STEPS).toVar()];
  return fromApex(w0, w1, w2)
    .mul(b.add(c).oneMinus())
    .add(fromApex(w1, w2, w0).mul(b))
    .add(fromApex(w2, w0, w1).mul(c))
    .toVar();
}

/** See `baseFactorOf` (pattern.ts). */
export function baseFactor(l01: Int, l12: Int, l20: Int): Int {
  const minFactor = minInt(minInt(l01, l12), l20);
  const maxFactor = maxInt(maxInt(l01, l12), l20);
  const middle = l01.add(l12).add(l20).sub(minFactor).sub(maxFactor).toVar();
  const base = minFactor.add(int(1)).add(maxFactor).sub(middle).toVar();
  return select(base.lessThan(maxFactor).and(base.lessThanEqual(middle)), base, maxFactor).toVar();
}

// TSL's min and max are for floats only.
export const maxInt = (a: Int, b: Int): Int => select(a.greaterThan(b), a, b).toVar();
const minInt = (a: Int, b: Int): Int => select(a.lessThan(b), a, b).toVar();

/** See `snapToEdge` (pattern.ts). */
function snapToEdge(k: Float, log2Factor: Int, base: Int): Float {
  const shift = int(MAX_LOG2_FACTOR).sub(log2Factor).toVar();
  const step = int(1).shiftLeft(shift).toVar();
  const width = int(EDGE_STEPS).shiftRight(base).toVar();
  const isStrip = k.lessThanEqual(float(width)).and(step.lessThanEqual(width));
  const roundUp = step.sub(int(1));
  const roundHalf = roundUp.shiftRight(int(1));
  return float(
    int(k)
      .add(select(isStrip, roundUp, roundHalf))
      .shiftRight(shift)
      .shiftLeft(shift),
  );
}
