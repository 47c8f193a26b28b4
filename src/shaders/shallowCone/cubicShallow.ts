import { int, select, vec4 } from 'three/tsl';
import type { Bool, Int, SampleTable, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { cubicPiece, cubicRoot, type EndVelocities, evaluateCubic } from '../worldLines/cubicPiece.ts';
import { pieceVelocity } from '../worldLines/pieceVelocity.ts';
import { linearShallow, shallowAnchor, shallowRate, shallowTime } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/**
 * The event on the cone ct′ = −λr′ of a vertex that moves along cubics between samples and is at rest outside them: bracketed Newton steps from the chord's
 * root. Arguments as in `polylineShallow`. docs/physics.md §5.8.
 */
export function cubicShallow(
  anchor: Vec4,
  at: SampleTable,
  velocities: EndVelocities,
  count: Int,
  observer: ShallowObserver,
): VertexEvent {
  const from = shallowAnchor(anchor, observer);
  const before = (sample: Vec4): Bool => sample.w.lessThanEqual(shallowTime(from, sample.xyz, observer));
  const index = bisect(count, (i) => before(at(i).toVar()));
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const piece = cubicPiece(a, b, velocities(index));
  const straight = linearShallow(from, pieceVelocity(a, b).toVar(), a, observer);
  const elapsed = cubicRoot(piece, straight, (s, x, velocity) => ({
    value: a.w.add(s).sub(shallowTime(from, x, observer)),
    slope: shallowRate(anchor.xyz.add(x), velocity, observer),
  })).toVar();
  const { x: moved, velocity: moving } = evaluateCubic(piece, elapsed);

  const early = before(a).not().toVar();
  const late = before(b).toVar();
  const resting = early.or(late);
  const x = select(early, a.xyz, select(late, b.xyz, moved)).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, shallowTime(from, x, observer), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
