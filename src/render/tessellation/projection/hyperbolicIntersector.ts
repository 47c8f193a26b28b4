import { add, dot, length, type Vec3 } from '../../../math/vec3.ts';
import type { HyperbolicLine } from '../../../physics/worldLines/kinds/hyperbolicLine.ts';
import type { HyperbolicMotion } from '../../../scene/types.ts';
import type { TrianglePoints } from '../../geometry/batchSolids.ts';
import { hyperbolicLineOfCenter, type MovingBody } from '../../geometry/bodies.ts';
import {
  intersect,
  type Observation,
  trailingPoint,
  type WorldTubeSection,
  worldTubeSection,
} from '../../geometry/observation.ts';
import type { ClusterBounds } from '../criterion/projectedBody.ts';
import type { EventBounds, HypersurfaceIntersector } from './projectedAcceleratedBody.ts';

/** A body in hyperbolic motion: each point has its own world line, and is not seen behind its horizon (docs/physics.md §4.4). */
export class HyperbolicIntersector implements HypersurfaceIntersector {
  readonly isRound: boolean;
  private readonly body: MovingBody;
  private readonly motion: HyperbolicMotion;
  private readonly points: TrianglePoints;
  private readonly observation: Observation;

  constructor(body: MovingBody, motion: HyperbolicMotion, points: TrianglePoints, observation: Observation) {
    this.body = body;
    this.motion = motion;
    this.points = points;
    this.isRound = points.isRound;
    this.observation = observation;
  }

  setTriangle(a: number, b: number, c: number): void {
    this.points.select(a, b, c);
  }

  intersect(w1: number, w2: number, out: Float64Array, at: number): void {
    const { points } = this;
    points.set(w1, w2);
    const event = intersect(this.lineAt([points.x, points.y, points.z]), this.observation);
    for (let k = 0; k < 3; k++) out[at + k] = event ? event.offset[k] : Number.NaN;
  }

  boundsOf({ x, y, z, radius }: ClusterBounds): EventBounds {
    const center: Vec3 = [x, y, z];
    const section = worldTubeSection(this.lineAt(center), radius, this.observation);
    if (!section)
      return {
        center: [0, 0, 0],
        radius: Number.POSITIVE_INFINITY,
        maxSpeed: 1,
        maxShear: 2,
        maxAcceleration: 0,
        maxVelocityJump: unbounded,
      };
    // In a Born rigid body the trailing point has the largest acceleration (docs/physics.md §4.5).
    const trailing = this.lineAt(add(center, trailingPoint(this.motion.properAcceleration, radius)));
    return {
      ...section.sphere,
      maxSpeed: this.maxSpeed(trailing, section),
      maxShear: 2,
      maxAcceleration: 0,
      maxVelocityJump: unbounded,
    };
  }

  private lineAt(offset: Vec3): HyperbolicLine {
    return hyperbolicLineOfCenter(this.body, this.motion, this.observation.c, offset);
  }

  /** v = κτ/√(1 + κ²τ²), κ = a/c², τ: time since the turning point [m of light]. */
  private maxSpeed(line: HyperbolicLine, { from, to }: WorldTubeSection): number {
    const { motion, observation } = this;
    const a = line.properAcceleration;
    // Beyond the body's own horizon nothing can be rigid.
    if (dot(a, motion.properAcceleration) < 0 || !Number.isFinite(length(a))) return 1;
    const since = observation.c * (observation.t - line.t0);
    const properSpeed =
      (length(a) / (observation.c * observation.c)) * Math.max(Math.abs(from + since), Math.abs(to + since));
    return properSpeed / Math.hypot(1, properSpeed);
  }
}

/** The velocity changes too smoothly to be bounded by sudden changes, so edges that are not short are tested by the criterion. */
const unbounded = (): number => Number.POSITIVE_INFINITY;
