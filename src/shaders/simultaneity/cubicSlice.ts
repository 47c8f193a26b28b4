import { dot, int, select, vec4 } from 'three/tsl';
import { lorentzFactorRatio } from '../kinematics/lorentzFactorRatio.ts';
import type { Float, Int, SampleTable, Vec3, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { cubicPiece, cubicRoot, type EndVelocities, evaluateCubic } from '../worldLines/cubicPiece.ts';

/**
 * The event on the observer's slice Δt′ = 0 of a vertex that moves along cubics between samples and is at rest outside them. `anchor` = (d_c, R) is an
 * event of the slice; `at` gives samples relative to it; 2 ≤ `count` ≤ 4096. u = 0: the slice of world time. docs/physics.md §5.4.
 */
export function cubicSlice(
  anchor: Vec4,
  at: SampleTable,
  velocities: EndVelocities,
  count: Int,
  u: Vec3,
  gamma: Float,
): VertexEvent {
  // γt − u·x increases along every world line and is 0 on the slice.
  const lead = (time: Float, x: Vec3): Float => gamma.mul(time).sub(dot(u, x));
  const index = bisect(count, (i) => {
    const sample = at(i).toVar();
    return lead(sample.w, sample.xyz).lessThanEqual(0);
  });
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const piece = cubicPiece(a, b, velocities(index));
  const elapsed = cubicRoot(piece, piece.span.mul(0.5), (s, x, velocity) => ({
    value: lead(a.w.add(s), x),
    slope: lorentzFactorRatio(u, gamma, velocity),
  })).toVar();
  const { x: moved, velocity: moving } = evaluateCubic(piece, elapsed);

  const early = lead(a.w, a.xyz).greaterThan(0).toVar();
  const late = lead(b.w, b.xyz).lessThan(0).toVar();
  const resting = early.or(late);
  const x = select(early, a.xyz, select(late, b.xyz, moved)).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, dot(u, x).div(gamma), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
