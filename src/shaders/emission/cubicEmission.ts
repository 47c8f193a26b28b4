import { int, length, max, select, vec4 } from 'three/tsl';
import { coneOffset } from '../kinematics/coneOffset.ts';
import { recession } from '../kinematics/recession.ts';
import type { Int, SampleTable, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { cubicPiece, cubicRoot, type EndVelocities, evaluateCubic } from '../worldLines/cubicPiece.ts';
import { pieceVelocity } from '../worldLines/pieceVelocity.ts';
import { linearEmission } from './linearEmission.ts';

/**
 * Emission event of a vertex that moves along cubics between samples and is at rest outside them: bisection finds the piece, bracketed Newton steps
 * started from the chord's root find the event. `anchor` = (d_c, R) [m]; `at` gives the vertex's samples relative to the anchor;
 * 2 ≤ `count` ≤ 4096. All control velocities are below 1. docs/physics.md §4.8.
 */
export function cubicEmission(anchor: Vec4, at: SampleTable, velocities: EndVelocities, count: Int): VertexEvent {
  const beforeCone = (sample: Vec4) => coneOffset(anchor, sample.xyz).add(sample.w).lessThanEqual(0);
  const index = bisect(count, (i) => beforeCone(at(i).toVar()));
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const piece = cubicPiece(a, b, velocities(index));
  const straight = linearEmission(anchor, pieceVelocity(a, b).toVar(), a);
  const elapsed = cubicRoot(piece, straight, (s, x, velocity) => {
    const dx = anchor.xyz.add(x).toVar();
    return {
      value: coneOffset(anchor, x).add(a.w.add(s)),
      slope: recession(dx.div(max(length(dx), 1e-20)).toVar(), velocity),
    };
  }).toVar();
  const { x: moved, velocity: moving } = evaluateCubic(piece, elapsed);

  // At rest outside the samples: the nearer end, at the time given by its distance.
  const early = beforeCone(a).not().toVar();
  const late = beforeCone(b).toVar();
  const resting = early.or(late);
  const x = select(early, a.xyz, select(late, b.xyz, moved)).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, coneOffset(anchor, x).negate(), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
