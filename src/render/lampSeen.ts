import { scale, type Vec3, ZERO } from '../math/vec3.ts';
import { originLine, poseAt } from '../scene/motion.ts';
import type { Lamp, Pose } from '../scene/types.ts';
import { meet, type Sight } from './sight.ts';

/** A lamp as it is uploaded: where it is relative to the observer's event [m], how its axes stand, and its colour. */
export interface SeenLamp extends Pose {
  readonly color: Vec3;
}

/**
 * Where the observer sees the lamp: that is taken for where it shines from on all surfaces, as if its light took no time to them
 * and had no shift of its own (docs/model.md). Dark where it is not seen.
 */
export function lampSeen({ motion, lifetime, color }: Lamp, sight: Sight): SeenLamp {
  const event = meet(originLine(motion), sight);
  const time = sight.t + (event?.ahead ?? 0) / sight.c;
  const { orientation } = poseAt(motion, time, sight.c);
  const shines = event && lifetime.birth <= time && time <= lifetime.death;
  return { position: event?.offset ?? ZERO, orientation, color: shines ? color : scale(color, 0) };
}
