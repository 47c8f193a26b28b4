import { asInertial, asPolyline } from '../../../physics/worldLines/worldLine.ts';
import { isCubic } from '../../../scene/motion/cubicPoints.ts';
import type { Motion, Pose } from '../../../scene/types.ts';
import type { BatchArrays, BatchInstancing } from '../../geometry/batches.ts';
import { type BatchSolid, TrianglePoints } from '../../geometry/batchSolids.ts';
import { type MovingBody, worldLineOfCenter } from '../../geometry/bodies.ts';
import { sampleWindow, worldTubeSection } from '../../geometry/observation.ts';
import type { ProjectedBody } from '../criterion/projectedBody.ts';
import type { ScreenMetric } from '../criterion/tessellationView.ts';
import { CubicPointsIntersector } from './cubicPointsIntersector.ts';
import { HyperbolicIntersector } from './hyperbolicIntersector.ts';
import { ProjectedAcceleratedBody } from './projectedAcceleratedBody.ts';
import { inertialMap, mapOfMesh, ProjectedInertialBody } from './projectedInertialBody.ts';
import { SampledPointsIntersector, SampledPosesIntersector, type SampleWindow } from './sampledIntersector.ts';

/** The part of a batch (batches.ts) that its plans are made from. */
export interface PlannedBatch {
  readonly transparent: boolean;
  readonly doubleSided: boolean;
  readonly bodies: readonly MovingBody[];
  readonly instancing?: BatchInstancing;
  readonly solids?: ReadonlyMap<number, BatchSolid>;
  readonly arrays: Pick<BatchArrays, 'positions' | 'indices' | 'ids'>;
}

/** A body of a batch in one view. */
interface Projection {
  readonly body: MovingBody;
  readonly batch: PlannedBatch;
  readonly metric: ScreenMetric;
}

const pointsOf = ({ body, batch: { arrays, solids } }: Projection): TrianglePoints =>
  new TrianglePoints(arrays.positions, solids?.get(body.id));

/** The projection of bodies with one kind of motion; returns undefined if nothing of the body is ever seen. */
interface BodyProjection<M extends Motion> {
  project(motion: M, projection: Projection): ProjectedBody | undefined;
}

function inertial(pose: Pose, projection: Projection): ProjectedBody | undefined {
  const { body, batch, metric } = projection;
  const { observation } = metric.view;
  const line = asInertial(worldLineOfCenter(body, observation.c));
  if (!line) return undefined;
  const map = inertialMap(line, body.object.authoredIn === 'rest', Math.max(body.radius, 1e-6), metric);
  const rotated = batch.instancing ? mapOfMesh(map, pose.orientation, body.object.stretch) : map;
  return new ProjectedInertialBody(rotated, pointsOf(projection), batch.doubleSided, metric);
}

const PROJECTIONS: { readonly [K in Motion['kind']]: BodyProjection<Extract<Motion, { readonly kind: K }>> } = {
  static: { project: ({ pose }, projection) => inertial(pose, projection) },
  uniform: { project: ({ pose }, projection) => inertial(pose, projection) },
  hyperbolic: {
    project: (motion, projection) =>
      new ProjectedAcceleratedBody(
        new HyperbolicIntersector(projection.body, motion, pointsOf(projection), projection.metric.view.observation),
        false,
        projection.metric,
      ),
  },
  sampled: {
    project: (motion, projection) => {
      const { body, metric } = projection;
      const { observation } = metric.view;
      const window = sampleWindowOf(body, metric);
      const line = asPolyline(worldLineOfCenter(body, observation.c));
      if (!line || !window) return undefined;
      const poses = new SampledPosesIntersector(motion, line, window, pointsOf(projection), observation);
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

/** A body of a batch as one view shows it; undefined if nothing of it is ever seen. */
export function projectBody(body: MovingBody, batch: PlannedBatch, metric: ScreenMetric): ProjectedBody | undefined {
  const { motion } = body.object;
  const projection: BodyProjection<Motion> = PROJECTIONS[motion.kind];
  return projection.project(motion, { body, batch, metric });
}

/** The samples that a view of a sampled body needs. */
export function sampleWindowOf(body: MovingBody, { view }: ScreenMetric): SampleWindow | undefined {
  const line = worldLineOfCenter(body, view.observation.c);
  const section = worldTubeSection(line, body.radius, view.observation);
  const samples = asPolyline(line);
  if (!samples || !section) return undefined;
  const [first, count] = sampleWindow(samples, section, view.observation, samples.times.length);
  return { first, count };
}
