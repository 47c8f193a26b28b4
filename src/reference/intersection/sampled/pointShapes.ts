import type { Vec3 } from '../../../math/vec3.ts';
import { sampleBoundingBox } from '../../../scene/bounds/bounds.ts';
import { isCubic } from '../../../scene/motion/cubicPoints.ts';
import type { ObjectWith } from '../../../scene/motion/kinds/motionKind.ts';
import { isListed, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import { emptyBox } from '../../acceleration/bvh.ts';
import { buildTriangleBvh, type TriangleBvh } from '../../acceleration/triangleBvh.ts';
import { CubicChords } from './cubicChords.ts';
import type { ShapeSource } from './sampledShapes.ts';

/** Shapes of a deforming mesh at its samples, or at the ends of the chords of its cubics. */
export class PointShapes implements ShapeSource {
  readonly times: Float64Array;
  readonly origin: Vec3;
  readonly topology: TriangleBvh;
  readonly ownsPoints: boolean;
  readonly cubic: CubicChords | undefined;
  private readonly motion: SampledPointsMotion;

  /** c [m/s] limits the bend of cubics. */
  constructor({ mesh, motion }: ObjectWith<SampledPointsMotion>, c: number) {
    this.motion = motion;
    this.cubic = isCubic(motion) ? new CubicChords(motion, c) : undefined;
    this.ownsPoints = !isListed(motion.points) || this.cubic !== undefined;
    this.times = this.cubic?.times ?? motion.times;
    this.origin = motion.origin;
    this.topology = buildTriangleBvh({ ...mesh, positions: middlePoints(motion) });
  }

  outline(k: number, boxes: Float64Array): void {
    if (this.cubic) {
      this.cubic.outline(k, boxes);
      return;
    }
    const box = sampleBoundingBox(this.motion, k);
    if (box) boxes.set([...box.min, ...box.max], 6 * k);
    else emptyBox(boxes, 6 * k);
  }

  pointsAt(k: number): Float32Array | Float64Array {
    return this.cubic?.at(k) ?? pointsAt(this.motion, k);
  }
}

/** The BVH is built for the middle sample and refitted to the others. */
const middlePoints = (motion: SampledPointsMotion): Float32Array => pointsAt(motion, motion.times.length >> 1);
