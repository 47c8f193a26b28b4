import { cross, dot, Fn, length, max, select, sqrt, vec4 } from 'three/tsl';
import { lorentzFactorRatio } from '../kinematics/lorentzFactorRatio.ts';
import { simultaneousPosition } from '../kinematics/simultaneousPosition.ts';
import type { Float, Vec3, Vec4 } from '../types.ts';
import type { ShallowObserver } from './shallowObserver.ts';
import { shallowPosition } from './shallowPosition.ts';

/** An event of the cone to which others are relative: (d_c, r′), from the observer in the world [m], and its distance in his frame. */
export const shallowAnchor = (anchor: Vec4, observer: ShallowObserver): Vec4 =>
  vec4(anchor.xyz, length(shallowPosition(anchor.xyz, observer))).toVar();

/** dx′/dct in the observer's frame of what moves with v in the world. */
const driftOf = (v: Vec3, u: Vec3, gamma: Float): Vec3 => v.add(u.mul(dot(u, v).div(gamma.add(1)).sub(1)));

/**
 * Time after `start` = (x, y, z, t), relative to the anchor, at which a point that continues from there with constant velocity meets the cone: the smaller
 * root of −Ms² + 2gs − q = 0 (`crossingTime` of src/physics/worldLines/shallowCone.ts). For f32, q is computed from the anchor, for which it is 0, and
 * T + d·v in conjugate form where the point approaches. `anchor`: see `shallowAnchor`; `velocity` = (v, 1 − v²); `observer` = (u, γ). docs/physics.md §5.8.
 */
const crossing = Fn(
  ([anchor, velocity, start, observer, slope]: [Vec4, Vec4, Vec4, Vec4, Float]): Float => {
    const [u, gamma, v] = [observer.xyz, observer.w, velocity.xyz.toVar()];
    const square = slope.mul(slope).toVar();
    const mu = slope.oneMinus().mul(slope.add(1)).toVar();
    const tau = anchor.w.mul(slope).negate().toVar();
    const time = dot(u, anchor.xyz).add(tau).div(gamma).toVar();

    const d = anchor.xyz.add(start.xyz).toVar();
    const T = time.add(start.w).negate().toVar();
    const later = gamma.mul(start.w).sub(dot(u, start.xyz)).toVar();
    const nearer = start.w
      .mul(start.w.add(time.mul(2)))
      .sub(dot(start.xyz, anchor.xyz.mul(2).add(start.xyz)))
      .toVar();
    const q = square
      .mul(nearer)
      .add(mu.mul(later).mul(later.add(tau.mul(2))))
      .toVar();

    const b = lorentzFactorRatio(u, gamma, velocity).toVar();
    const along = dot(d, v).toVar();
    const across = cross(d, v).toVar();
    const approaching = nearer
      .sub(mu.mul(anchor.w).mul(anchor.w))
      .add(dot(d, d).mul(velocity.w))
      .add(dot(across, across))
      .div(T.sub(along));
    const U = select(along.lessThan(0).and(T.greaterThan(0)), approaching, T.add(along));
    const g = square
      .mul(U)
      .sub(mu.mul(b).mul(tau.add(later)))
      .toVar();
    const M = square.mul(velocity.w).add(mu.mul(b).mul(b)).toVar();

    const S = simultaneousPosition(d.sub(v.mul(tau.add(later).div(b))), u, gamma).toVar();
    const Sq = dot(S, driftOf(v, u, gamma)).toVar();
    const root = slope.mul(sqrt(M.mul(dot(S, S)).add(square.mul(Sq).mul(Sq)))).toVar();
    return select(g.greaterThan(0), q.div(max(g.add(root), 1e-30)), g.sub(root).div(M));
  },
  { anchor: 'vec4', velocity: 'vec4', start: 'vec4', observer: 'vec4', slope: 'float', return: 'float' },
);

export const linearShallow = (
  anchor: Vec4,
  velocity: Vec4,
  start: Vec4,
  { u, gamma, coneSlope }: ShallowObserver,
): Float => crossing(anchor, velocity, start, vec4(u, gamma), coneSlope);

/** The time of the cone at the point x (relative to the anchor) after the anchor's. */
export const shallowTime = (anchor: Vec4, x: Vec3, observer: ShallowObserver): Float =>
  linearShallow(anchor, vec4(0, 0, 0, 1), vec4(x, 0), observer);

/** d(t − time of the cone)/dt along a line with this velocity that meets the cone at Δx. */
export function shallowRate(dx: Vec3, velocity: Vec4, observer: ShallowObserver): Float {
  const { u, gamma, coneSlope } = observer;
  const place = shallowPosition(dx, observer).toVar();
  const n = place.div(max(length(place), 1e-20)).toVar();
  const rate = lorentzFactorRatio(u, gamma, velocity).add(coneSlope.mul(dot(n, driftOf(velocity.xyz, u, gamma))));
  return rate.div(gamma.sub(coneSlope.mul(dot(n, u))));
}
