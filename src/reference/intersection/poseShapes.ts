import { toMatrix } from '../../math/quat.ts';
import { sub, type Vec3 } from '../../math/vec3.ts';
import { boundingBox } from '../../scene/bounds/bounds.ts';
import type { ObjectWith } from '../../scene/motion/kinds/motionKind.ts';
import { samplePose } from '../../scene/motion/poses.ts';
import type { Mesh, SampledMotion } from '../../scene/types.ts';
import { emptyBox } from '../acceleration/bvh.ts';
import { meshBvh, type TriangleBvh } from '../acceleration/triangleBvh.ts';
import type { ShapeSource } from './sampledShapes.ts';

/** Shapes of a rigid mesh at its poses. */
export class PoseShapes implements ShapeSource {
  readonly times: Float64Array;
  readonly origin: Vec3;
  readonly topology: TriangleBvh;
  readonly ownsPoints = true;
  readonly cubic = undefined;
  private readonly mesh: Mesh;
  private readonly motion: SampledMotion;

  constructor({ mesh, motion }: ObjectWith<SampledMotion>) {
    this.mesh = mesh;
    this.motion = motion;
    this.times = motion.times;
    this.origin = samplePose(motion.poses, 0).position;
    this.topology = meshBvh(mesh);
  }

  /** The half extents of the rotated box's bounding box are |R| times those of the box. */
  outline(k: number, boxes: Float64Array): void {
    const box = boundingBox(this.mesh.positions);
    if (!box) {
      emptyBox(boxes, 6 * k);
      return;
    }
    const { position, orientation } = samplePose(this.motion.poses, k);
    const r = toMatrix(orientation);
    const from = sub(position, this.origin);
    for (let i = 0; i < 3; i++) {
      let [middle, half] = [from[i], 0];
      for (let j = 0; j < 3; j++) {
        middle += (r[3 * i + j] * (box.min[j] + box.max[j])) / 2;
        half += (Math.abs(r[3 * i + j]) * (box.max[j] - box.min[j])) / 2;
      }
      boxes[6 * k + i] = middle - half;
      boxes[6 * k + 3 + i] = middle + half;
    }
  }

  pointsAt(k: number): Float64Array {
    const { position, orientation } = samplePose(this.motion.poses, k);
    const r = toMatrix(orientation);
    const [px, py, pz] = sub(position, this.origin);
    const from = this.mesh.positions;
    const out = new Float64Array(from.length);
    for (let i = 0; i < from.length; i += 3) {
      const [x, y, z] = [from[i], from[i + 1], from[i + 2]];
      out[i] = px + r[0] * x + r[1] * y + r[2] * z;
      out[i + 1] = py + r[3] * x + r[4] * y + r[5] * z;
      out[i + 2] = pz + r[6] * x + r[7] * y + r[8] * z;
    }
    return out;
  }
}
