import { vec4 } from 'three/tsl';
import type { Vec4 } from '../types.ts';
import { linearShallow } from './linearShallow.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/** As `ontoLightCone`, onto the cone ct′ = −λr′. docs/physics.md §5.8. */
export function ontoShallowCone(event: Vec4, velocity: Vec4, observer: ShallowObserver): Vec4 {
  // Relative to the observer's own event, which is on the cone.
  const s = linearShallow(vec4(0), velocity, event, observer).toVar();
  return event.add(vec4(velocity.xyz, 1).mul(s));
}
