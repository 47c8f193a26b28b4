import { clamp, int, select, vec4 } from 'three/tsl';
import type { Bool, Int, SampleTable, Vec4, VertexEvent } from '../types.ts';
import { bisect } from '../worldLines/bisect.ts';
import { pieceVelocity } from '../worldLines/pieceVelocity.ts';
import { linearShallow, shallowAnchor, shallowTime } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/**
 * The event on the cone ct′ = −λr′ of a vertex that moves uniformly between samples and is at rest outside them. `anchor` is an event of the cone; `at` gives
 * samples relative to it; 2 ≤ `count` ≤ 4096. docs/physics.md §5.8.
 */
export function polylineShallow(anchor: Vec4, at: SampleTable, count: Int, observer: ShallowObserver): VertexEvent {
  const from = shallowAnchor(anchor, observer);
  const before = (sample: Vec4): Bool => sample.w.lessThanEqual(shallowTime(from, sample.xyz, observer));
  const index = bisect(count, (i) => before(at(i).toVar()));
  const a = at(index).toVar();
  const b = at(index.add(int(1))).toVar();
  const moving = pieceVelocity(a, b).toVar();
  const elapsed = clamp(linearShallow(from, moving, a, observer), 0, b.w.sub(a.w)).toVar();

  const early = before(a).not().toVar();
  const late = before(b).toVar();
  const resting = early.or(late);
  const x = select(early, a.xyz, select(late, b.xyz, a.xyz.add(moving.xyz.mul(elapsed)))).toVar();
  return {
    dx: anchor.xyz.add(x),
    s: select(resting, shallowTime(from, x, observer), a.w.add(elapsed)),
    velocity: select(resting, vec4(0, 0, 0, 1), moving),
  };
}
