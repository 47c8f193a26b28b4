import { select, vec4 } from 'three/tsl';
import { fullVelocity } from '../kinematics/fullVelocity.ts';
import type { Vec4 } from '../types.ts';
import { linearShallow } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/** Below this, 1 − v² is better known as it is given than from v [f32]. */
const ROUNDING = 1e-6;

/**
 * As `ontoLightCone`, onto the cone ct′ = −λr′. docs/physics.md §5.8. Between vertices of different velocities 1 − v² is interpolated to too little: unlike
 * there, that would count in first order.
 */
export function ontoShallowCone(event: Vec4, given: Vec4, observer: ShallowObserver): Vec4 {
  const own = fullVelocity(given.xyz).toVar();
  const velocity = select(own.w.sub(given.w).greaterThan(ROUNDING), own, given).toVar();
  // Relative to the observer's own event, which is on the cone.
  const s = linearShallow(vec4(0), velocity, event, observer).toVar();
  return event.add(vec4(velocity.xyz, 1).mul(s));
}
