import { clamp, dot, int, select, vec4 } from 'three/tsl';
import { lorentzFactorRatio } from '../kinematics/lorentzFactorRatio.ts';
import type { Float, Int, SampleTable, Vec3, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { pieceVelocity } from '../worldLines/pieceVelocity.ts';

/**
 * The event on the observer's slice Δt′ = 0 of a vertex that moves uniformly between samples and is at rest outside them.
 * `anchor` = (d_c, R) is an event of the slice; `at` gives samples relative to it; 2 ≤ `count` ≤ 4096. u = 0: the slice of world time. docs/physics.md §5.4.
 * @example
 * import { float, int, select, vec3, vec4 } from 'three/tsl';
 * const samples = (i: Int) => select(i.equal(int(0)), vec4(0, 0, 0, -1), vec4(1, 0, 0, 1));
 * const { dx } = polylineSlice(vec4(0, 0, -4, 4), samples, int(2), vec3(0), float(1));
 */
export function polylineSlice(anchor: Vec4, at: SampleTable, count: Int, u: Vec3, gamma: Float): VertexEvent {
  // γt − u·x increases along every world line and is 0 on the slice.
  const lead = (sample: Vec4): Float => gamma.mul(sample.w).sub(dot(u, sample.xyz));
  const index = bisect(count, (i) => lead(at(i).toVar()).lessThanEqual(0));
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const moving = pieceVelocity(a, b).toVar();
  const elapsed = clamp(
    lead(a)
      .negate()
      .div(lorentzFactorRatio(u, gamma, moving)),
    0,
    b.w.sub(a.w),
  ).toVar();

  const early = lead(a).greaterThan(0).toVar();
  const late = lead(b).lessThan(0).toVar();
  const resting = early.or(late);
  const x = select(early, a.xyz, select(late, b.xyz, a.xyz.add(moving.xyz.mul(elapsed)))).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, dot(u, x).div(gamma), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
