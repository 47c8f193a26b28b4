import { dot, length, max } from 'three/tsl';
import { apparentPosition } from '../kinematics/apparentPosition.ts';
import type { Vec3 } from '../types.ts';
import type { ShallowObserver } from './shallowObserver.ts';

/**
 * Observer-frame position of the event at Δx on the cone ct′ = −λr′: the apparent position in the slowed world, where lengths along u are γ_λ/γ times those of
 * the world. `dx` [m]: observer → event, world frame. docs/physics.md §5.8.
 */
export function shallowPosition(dx: Vec3, { u, gamma, slowedU, slowedGamma }: ShallowObserver): Vec3 {
  const axis = u.div(max(length(u), 1e-20)).toVar();
  const along = dot(axis, dx).toVar();
  const slowed = dx
    .sub(axis.mul(along))
    .add(axis.mul(along.mul(slowedGamma).div(gamma)))
    .toVar();
  return apparentPosition(slowed, slowedU, slowedGamma);
}
