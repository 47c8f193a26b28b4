import { isCubic } from '../../../scene/motion/cubicPoints.ts';
import type { BatchArrays, BatchInstancing } from '../../geometry/batches.ts';
import { type MovingBody, worldLineOfCenter } from '../../geometry/bodies.ts';
import { sampleWindow, worldTubeSection } from '../../geometry/observation.ts';
import type { ProjectedBody } from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { CubicPointsIntersector } from './cubicPointsIntersector.ts';
import { HyperbolicIntersector } from './hyperbolicIntersector.ts';
import { ProjectedAcceleratedBody } from './projectedAcceleratedBody.ts';
import { inertialMap, ProjectedInertialBody, rotatedMap } from './projectedInertialBody.ts';
import { SampledPointsIntersector, SampledPosesIntersector, type SampleWindow } from './sampledIntersector.ts';

/** As much of a batch (batches.ts) as its plans are made from. */
export interface PlannedBatch {
  readonly transparent: boolean;
  readonly doubleSided: boolean;
  readonly bodies: readonly MovingBody[];
  readonly instancing?: BatchInstancing;
  readonly arrays: Pick<BatchArrays, 'positions' | 'indices' | 'ids'>;
}

/** How a body of a batch is shown in one picture; undefined where nothing of it ever is. */
export function projectBody(
  body: MovingBody,
  { arrays, doubleSided, instancing: worn }: PlannedBatch,
  gauge: ScreenMetric,
): ProjectedBody | undefined {
  const { motion, authoredIn } = body.object;
  const { observation } = gauge.view;
  const line = worldLineOfCenter(body, observation.c);
  if (line.kind === 'static' || line.kind === 'uniform') {
    const map = inertialMap(line, authoredIn === 'rest', Math.max(body.radius, 1e-6), gauge);
    const own = worn && 'pose' in motion ? rotatedMap(map, motion.pose.orientation) : map;
    return new ProjectedInertialBody(own, arrays.positions, doubleSided, gauge);
  }
  if (motion.kind === 'hyperbolic')
    return new ProjectedAcceleratedBody(
      new HyperbolicIntersector(body, motion, arrays.positions, observation),
      false,
      gauge,
    );
  const window = sampleWindowOf(body, gauge);
  if (line.kind !== 'polyline' || !window) return undefined;
  if (motion.kind === 'sampled')
    return new ProjectedAcceleratedBody(
      new SampledPosesIntersector(motion, line, window, arrays.positions, observation),
      true,
      gauge,
    );
  if (motion.kind !== 'sampled-points') return undefined;
  if (!isCubic(motion))
    return new ProjectedAcceleratedBody(new SampledPointsIntersector(motion, window, observation), true, gauge);
  const cubic = new CubicPointsIntersector(motion, window, observation);
  return new ProjectedAcceleratedBody(cubic, !cubic.smooth, gauge);
}

/** The samples that a picture of a sampled body needs. */
export function sampleWindowOf(body: MovingBody, { view: look }: ScreenMetric): SampleWindow | undefined {
  const line = worldLineOfCenter(body, look.observation.c);
  const span = worldTubeSection(line, body.radius, look.observation);
  if (line.kind !== 'polyline' || !span) return undefined;
  const [first, count] = sampleWindow(line, span, look.observation, line.times.length);
  return { first, count };
}
