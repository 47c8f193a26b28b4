import { length, select, vec4 } from 'three/tsl';
import type { Vec4 } from '../types.ts';
import { linearShallow } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/** Below this, 1 − v² is better known as it is given than from v [f32]. */
const ROUNDING = 1e-6;

/**
 * As `ontoLightCone`, onto the cone ct′ = −λr′. docs/physics.md §5.8. Between vertices of different velocities 1 − v² is interpolated to too little: unlike
 * there, that would count in first order.
 */
export function ontoShallowCone(event: Vec4, { xyz: v, w }: Vec4, observer: ShallowObserver): Vec4 {
  const speed = length(v).toVar();
  const own = speed.oneMinus().mul(speed.add(1)).toVar();
  const velocity = vec4(v, select(own.sub(w).greaterThan(ROUNDING), own, w)).toVar();
  // Relative to the observer's own event, which is on the cone.
  const s = linearShallow(vec4(0), velocity, event, observer).toVar();
  return event.add(vec4(velocity.xyz, 1).mul(s));
}
