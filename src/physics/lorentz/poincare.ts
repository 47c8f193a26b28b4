import { IDENTITY, type Mat4, multiply } from '../../math/mat4.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { boostMatrix } from './boost.ts';
import type { FourVector } from './fourVector.ts';

/** X′ = Λ X + a: a transformation between any two inertial frames (docs/physics.md §2.2). */
export interface Poincare {
  /** Λ, row by row, on (ct, x, y, z). */
  readonly lorentz: Mat4;
  /** a [m] */
  readonly translation: FourVector;
}

/**
 * The transformation that changes nothing.
 * @example
 * applyPoincare(POINCARE_IDENTITY, [1, 2, 3, 4]); // [1, 2, 3, 4]
 */
export const POINCARE_IDENTITY: Poincare = { lorentz: IDENTITY, translation: [0, 0, 0, 0] };

/**
 * Λ X [m]
 * @example
 * applyLorentz(boostMatrix([0.75, 0, 0]), [0, 4, 0, 0]); // [-3, 5, 0, 0]
 */
export const applyLorentz = (l: Mat4, [t, x, y, z]: FourVector): FourVector => [
  l[0] * t + l[1] * x + l[2] * y + l[3] * z,
  l[4] * t + l[5] * x + l[6] * y + l[7] * z,
  l[8] * t + l[9] * x + l[10] * y + l[11] * z,
  l[12] * t + l[13] * x + l[14] * y + l[15] * z,
];

const plus = (A: FourVector, B: FourVector): FourVector => [A[0] + B[0], A[1] + B[1], A[2] + B[2], A[3] + B[3]];
const minus = (A: FourVector): FourVector => [-A[0], -A[1], -A[2], -A[3]];

/**
 * Λ X + a
 * @example
 * applyPoincare(frameAt([1, 2, 0, 0], [0.75, 0, 0]), [1, 6, 0, 0]); // [-3, 5, 0, 0]
 */
export const applyPoincare = (p: Poincare, X: FourVector): FourVector =>
  plus(applyLorentz(p.lorentz, X), p.translation);

/**
 * `first` followed by `then`.
 * @example
 * const there = frameAt([1, 2, 0, 0], [0.75, 0, 0]);
 * applyPoincare(composePoincare(invertPoincare(there), there), [1, 2, 3, 4]); // [1, 2, 3, 4]
 */
export const composePoincare = (then: Poincare, first: Poincare): Poincare => ({
  lorentz: multiply(then.lorentz, first.lorentz),
  translation: applyPoincare(then, first.translation),
});

/**
 * Λ⁻¹ = η Λᵀ η with η = diag(−1, 1, 1, 1); exact, without elimination.
 * @example
 * inverseLorentz(boostMatrix([0.75, 0, 0])).slice(0, 4); // [1.25, 0.75, 0, 0]
 */
export const inverseLorentz = (l: Mat4): Mat4 => [
  ...[l[0], -l[4], -l[8], -l[12]],
  ...[-l[1], l[5], l[9], l[13]],
  ...[-l[2], l[6], l[10], l[14]],
  ...[-l[3], l[7], l[11], l[15]],
];

/**
 * X = Λ⁻¹(X′ − a)
 * @example
 * // Where the frame's own origin is 1 m of light later, in the world.
 * applyPoincare(invertPoincare(frameAt([0, 0, 0, 0], [0.75, 0, 0])), [1, 0, 0, 0]); // [1.25, 0.75, 0, 0]
 */
export function invertPoincare(p: Poincare): Poincare {
  const lorentz = inverseLorentz(p.lorentz);
  return { lorentz, translation: applyLorentz(lorentz, minus(p.translation)) };
}

/**
 * World → the frame X′ = B(u)(X − origin) with proper velocity u whose origin is at the event `origin` [m].
 * @example
 * applyPoincare(frameAt([1, 2, 0, 0], [0.75, 0, 0]), [1, 2, 0, 0]); // [0, 0, 0, 0]
 */
export function frameAt(origin: FourVector, u: Vec3): Poincare {
  const lorentz = boostMatrix(u);
  return { lorentz, translation: applyLorentz(lorentz, minus(origin)) };
}
