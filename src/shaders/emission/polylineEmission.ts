import { clamp, int, select, vec4 } from 'three/tsl';
import { coneOffset } from '../kinematics/coneOffset.ts';
import type { Int, SampleTable, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { pieceVelocity } from '../worldLines/pieceVelocity.ts';
import { linearEmission } from './linearEmission.ts';

/**
 * Emission event of a vertex that moves uniformly between samples and is at rest outside them: bisection finds the piece, a closed form
 * the root, clamped to the piece. `anchor` = (d_c, R) [m]; `at` gives the vertex's samples
 * relative to the anchor; 2 ≤ `count` ≤ 4096. Exact, without an iteration that could fail. docs/physics.md §4.3, §4.7.
 * @example
 * import { int, select, vec4 } from 'three/tsl';
 * const samples = (i: Int) => select(i.equal(int(0)), vec4(0, 0, 0, -1), vec4(1, 0, 0, 1));
 * const { dx, velocity } = polylineEmission(vec4(0, 0, -4, 4), samples, int(2));
 */
export function polylineEmission(anchor: Vec4, at: SampleTable, count: Int): VertexEvent {
  const beforeCone = (sample: Vec4) => coneOffset(anchor, sample.xyz).add(sample.w).lessThanEqual(0);
  const index = bisect(count, (i) => beforeCone(at(i).toVar()));
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const moving = pieceVelocity(a, b).toVar();
  const elapsed = clamp(linearEmission(anchor, moving, a), 0, b.w.sub(a.w)).toVar();

  // At rest outside the samples: the nearer end, at the time given by its distance.
  const resting = beforeCone(a).not().or(beforeCone(b)).toVar();
  const moved = select(beforeCone(b), b.xyz, a.xyz.add(moving.xyz.mul(elapsed)));
  const x = select(beforeCone(a), moved, a.xyz).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, coneOffset(anchor, x).negate(), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
