import { asInertial, asPolyline } from '../../../physics/worldLines/worldLine.ts';
import { isCubic } from '../../../scene/motion/cubicPoints.ts';
import type { Motion, Pose } from '../../../scene/types.ts';
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

/** A body of a batch in one picture. */
interface Projection {
  readonly body: MovingBody;
  readonly batch: PlannedBatch;
  readonly metric: ScreenMetric;
}

/** How a body is shown, by the kind of its motion; undefined where nothing of it ever is. */
interface BodyProjection<M extends Motion> {
  project(motion: M, projection: Projection): ProjectedBody | undefined;
}

function inertial(pose: Pose, { body, batch, metric }: Projection): ProjectedBody | undefined {
  const { observation } = metric.view;
  const line = asInertial(worldLineOfCenter(body, observation.c));
  if (!line) return undefined;
  const map = inertialMap(line, body.object.authoredIn === 'rest', Math.max(body.radius, 1e-6), metric);
  const own = batch.instancing ? rotatedMap(map, pose.orientation) : map;
  return new ProjectedInertialBody(own, batch.arrays.positions, batch.doubleSided, metric);
}

const PROJECTIONS: { readonly [K in Motion['kind']]: BodyProjection<Extract<Motion, { readonly kind: K }>> } = {
  static: { project: ({ pose }, projection) => inertial(pose, projection) },
  uniform: { project: ({ pose }, projection) => inertial(pose, projection) },
  hyperbolic: {
    project: (motion, { body, batch, metric }) =>
      new ProjectedAcceleratedBody(
        new HyperbolicIntersector(body, motion, batch.arrays.positions, metric.view.observation),
        false,
        metric,
      ),
  },
  sampled: {
    project: (motion, { body, batch, metric }) => {
      const { observation } = metric.view;
      const window = sampleWindowOf(body, metric);
      const line = asPolyline(worldLineOfCenter(body, observation.c));
      if (!line || !window) return undefined;
      const poses = new SampledPosesIntersector(motion, line, window, batch.arrays.positions, observation);
      return new ProjectedAcceleratedBody(poses, true, metric);
    },
  },
  'sampled-points': {
    project: (motion, { body, metric }) => {
      const { observation } = metric.view;
      const window = sampleWindowOf(body, metric);
      if (!window) return undefined;
      if (!isCubic(motion))
        return new ProjectedAcceleratedBody(new SampledPointsIntersector(motion, window, observation), true, metric);
      const cubic = new CubicPointsIntersector(motion, window, observation);
      return new ProjectedAcceleratedBody(cubic, !cubic.smooth, metric);
    },
  },
};

/** How a body of a batch is shown in one picture; undefined where nothing of it ever is. */
export function projectBody(body: MovingBody, batch: PlannedBatch, metric: ScreenMetric): ProjectedBody | undefined {
  const { motion } = body.object;
  const projection: BodyProjection<Motion> = PROJECTIONS[motion.kind];
  return projection.project(motion, { body, batch, metric });
}

/** The samples that a picture of a sampled body needs. */
export function sampleWindowOf(body: MovingBody, { view: look }: ScreenMetric): SampleWindow | undefined {
  const line = worldLineOfCenter(body, look.observation.c);
  const span = worldTubeSection(line, body.radius, look.observation);
  const samples = asPolyline(line);
  if (!samples || !span) return undefined;
  const [first, count] = sampleWindow(samples, span, look.observation, samples.times.length);
  return { first, count };
}
