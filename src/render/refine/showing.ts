import type { BatchArrays, Worn } from '../batches.ts';
import { lineOfCentre, type MovingBody } from '../bodies.ts';
import { sampleWindow, spanOf } from '../sight.ts';
import { Hyperbolic } from './hyperbolic.ts';
import type { Gauge } from './look.ts';
import { Moving } from './moving.ts';
import { Deforming, Posed, type Window } from './polyline.ts';
import type { Shown } from './shown.ts';
import { Steady, steadyMap, turnedMap } from './steady.ts';

/** As much of a batch (batches.ts) as its plans are made from. */
export interface PlannedBatch {
  readonly transparent: boolean;
  readonly doubleSided: boolean;
  readonly bodies: readonly MovingBody[];
  readonly worn?: Worn;
  readonly arrays: Pick<BatchArrays, 'positions' | 'indices' | 'ids'>;
}

/** How a body of a batch is shown in one picture; undefined where nothing of it ever is. */
export function showing(
  body: MovingBody,
  { arrays, doubleSided, worn }: PlannedBatch,
  gauge: Gauge,
): Shown | undefined {
  const { motion, authoredIn } = body.object;
  const { sight } = gauge.look;
  const line = lineOfCentre(body, sight.c);
  if (line.kind === 'static' || line.kind === 'uniform') {
    const map = steadyMap(line, authoredIn === 'rest', Math.max(body.radius, 1e-6), gauge);
    const own = worn && 'pose' in motion ? turnedMap(map, motion.pose.orientation) : map;
    return new Steady(own, arrays.positions, doubleSided, gauge);
  }
  if (motion.kind === 'hyperbolic')
    return new Moving(new Hyperbolic(body, motion, arrays.positions, sight), false, gauge);
  const window = windowOf(body, gauge);
  if (line.kind !== 'polyline' || !window) return undefined;
  if (motion.kind === 'sampled')
    return new Moving(new Posed(motion, line, window, arrays.positions, sight), true, gauge);
  return motion.kind === 'sampled-points' ? new Moving(new Deforming(motion, window, sight), true, gauge) : undefined;
}

/** The samples that a picture of a sampled body needs. */
export function windowOf(body: MovingBody, { look }: Gauge): Window | undefined {
  const line = lineOfCentre(body, look.sight.c);
  const span = spanOf(line, body.radius, look.sight);
  if (line.kind !== 'polyline' || !span) return undefined;
  const [first, count] = sampleWindow(line, span, look.sight, line.times.length);
  return { first, count };
}
