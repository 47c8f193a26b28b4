import { sub, type Vec3 } from '../../math/vec3.ts';
import { parallaxBound } from '../../scene/view/capture.ts';
import type { Batch } from '../geometry/batches.ts';
import type { Body } from '../geometry/bodies.ts';
import type { Observation } from '../geometry/observation.ts';
import { isAlwaysStatic } from '../shadows/distant/staticDistantShadows.ts';

/** Where and when a capture was taken. */
export type CaptureEvent = Pick<Observation, 't' | 'position'>;

/** Whether a capture can hold a batch: light is computed anew from what it holds, which is the front surface, without its layers. */
export const isCapturable = ({ transparent, layered }: Batch): boolean => !transparent && !layered;

/**
 * Upper bound of the angle at rest by which bodies of a batch are seen elsewhere than from the event of a capture [rad]; ∞ if nothing bounds it: at another event
 * whatever moves is seen at another time of its own.
 */
export function captureError({ bodies }: Batch, from: CaptureEvent, to: CaptureEvent): number {
  const moved = sub(to.position, from.position);
  const isSamePlace = moved.every((x) => x === 0);
  if (isSamePlace && to.t === from.t) return 0;
  return bodies.reduce((most, body) => Math.max(most, bodyError(body, from, moved)), 0);
}

function bodyError(body: Body, { position }: CaptureEvent, moved: Vec3): number {
  if (!isAlwaysStatic(body) || body.line.kind !== 'static') return Number.POSITIVE_INFINITY;
  return parallaxBound(sub(body.line.position, position), body.radius, moved);
}
