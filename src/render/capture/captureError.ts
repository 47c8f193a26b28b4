import { sub } from '../../math/vec3.ts';
import { parallaxBound } from '../../scene/view/captureBounds.ts';
import type { Body } from '../geometry/bodies.ts';
import type { Observation } from '../geometry/observation.ts';
import { isAlwaysStatic } from '../shadows/distant/staticDistantShadows.ts';

/** Where and when a capture was taken. */
export type CaptureEvent = Pick<Observation, 't' | 'position'>;

export const isSameEvent = (a: CaptureEvent, b: CaptureEvent): boolean =>
  a.t === b.t && a.position.every((x, i) => x === b.position[i]);

/**
 * Upper bound of the angle at rest by which a body is seen elsewhere than from the event of a capture [rad]; ∞ if nothing bounds it: at another event whatever
 * moves is seen at another time of its own.
 */
export function captureError(body: Body, from: CaptureEvent, to: CaptureEvent): number {
  if (isSameEvent(from, to)) return 0;
  if (!isAlwaysStatic(body) || body.line.kind !== 'static') return Number.POSITIVE_INFINITY;
  return parallaxBound(sub(body.line.position, from.position), body.radius, sub(to.position, from.position));
}
