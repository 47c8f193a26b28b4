import { vec4 } from 'three/tsl';
import type { Vec3, Vec4, VertexEvent } from '../types.ts';
import { linearShallow, shallowAnchor } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/**
 * The event on the cone ct′ = −λr′ of a vertex that moves uniformly (or rests) and is at `offset` [m] from the anchor, an event of the cone, at its time.
 * `velocity` = (v, 1 − v²). docs/physics.md §5.8.
 */
export function uniformShallow(anchor: Vec4, velocity: Vec4, offset: Vec3, observer: ShallowObserver): VertexEvent {
  const s = linearShallow(shallowAnchor(anchor, observer), velocity, vec4(offset, 0), observer).toVar();
  return { dx: anchor.xyz.add(offset.add(velocity.xyz.mul(s))), s, velocity };
}
