import { cofactors, determinant, IDENTITY, type Mat3, multiply as times3, transpose } from '../../../../math/mat3.ts';
import { closestRotation } from '../../../../math/polar.ts';
import { multiply, type Quat, rotate, toMatrix } from '../../../../math/quat.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { blendMatrices, type SkinInfluences } from '../../../read/skinning.ts';

/** Joint transforms as a stretch followed by a dual quaternion (rotation and translation). */
export interface JointDualQuaternions {
  /** Real and dual part, 8 numbers per joint. */
  readonly duals: Float64Array;
  /** 9 numbers per joint, for points and for normals; absent if no joint stretches. */
  readonly stretches?: { readonly points: Float64Array; readonly normals: Float64Array };
}

/** Deviations from the identity below this are rounding. */
const STRETCH_EPSILON = 1e-6;

/** @param matrices three rows of four per joint */
export function jointDualQuaternions(matrices: Float64Array): JointDualQuaternions {
  const joints = matrices.length / 12;
  const duals = new Float64Array(8 * joints);
  const stretches = { points: new Float64Array(9 * joints), normals: new Float64Array(9 * joints) };
  let isStretched = false;
  for (let j = 0; j < joints; j++) {
    const m = matrices.subarray(12 * j, 12 * j + 12);
    const linear = [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];
    const q = closestRotation(linear);
    const stretch = times3(transpose(toMatrix(q)), linear);
    stretches.points.set(stretch, 9 * j);
    stretches.normals.set(inverseTranspose(stretch), 9 * j);
    isStretched ||= stretch.some((x, i) => Math.abs(x - (i % 4 === 0 ? 1 : 0)) > STRETCH_EPSILON);
    duals.set(q, 8 * j);
    // ε part: t q / 2.
    duals.set(
      multiply([m[3], m[7], m[11], 0], q).map((x) => x / 2),
      8 * j + 4,
    );
  }
  return { duals, ...(isStretched ? { stretches } : {}) };
}

/** Dual quaternion skinning (Kavan et al. 2007): the normalized blend, each with the sign of the joint of largest weight. */
export class DualQuaternionBlend {
  private readonly joints: JointDualQuaternions;
  private readonly influences: SkinInfluences;
  private readonly stretches: Float64Array | undefined;
  private readonly stretch = new Float64Array(9);
  private readonly dual = new Float64Array(8);

  constructor(joints: JointDualQuaternions, influences: SkinInfluences, of: 'points' | 'normals') {
    this.joints = joints;
    this.stretches = joints.stretches?.[of];
    this.influences = influences;
  }

  /** Sets the blend of a point's influences. */
  at(point: number): void {
    const { duals } = this.joints;
    if (this.stretches) blendMatrices(this.stretch, this.stretches, 9, this.influences, point);
    const { perPoint, joints, weights } = this.influences;
    const first = point * perPoint;
    let heaviest = first;
    for (let i = first; i < first + perPoint; i++) if (weights[i] > weights[heaviest]) heaviest = i;
    const pivot = 8 * joints[heaviest];
    this.dual.fill(0);
    for (let i = first; i < first + perPoint; i++) {
      const from = 8 * joints[i];
      let cosine = 0;
      for (let k = 0; k < 4; k++) cosine += duals[from + k] * duals[pivot + k];
      const w = cosine < 0 ? -weights[i] : weights[i];
      for (let k = 0; k < 8; k++) this.dual[k] += w * duals[from + k];
    }
    const length = Math.hypot(this.dual[0], this.dual[1], this.dual[2], this.dual[3]);
    if (length > 0) for (let k = 0; k < 8; k++) this.dual[k] /= length;
  }

  point(p: Vec3): Vec3 {
    const d = this.dual;
    const real: Quat = [d[0], d[1], d[2], d[3]];
    const turned = rotate(real, this.stretches ? apply(this.stretch, p) : p);
    const t = multiply([d[4], d[5], d[6], d[7]], [-d[0], -d[1], -d[2], d[3]]);
    return [turned[0] + 2 * t[0], turned[1] + 2 * t[1], turned[2] + 2 * t[2]];
  }

  /** Not normalized. */
  normal(n: Vec3): Vec3 {
    const d = this.dual;
    return rotate([d[0], d[1], d[2], d[3]], this.stretches ? apply(this.stretch, n) : n);
  }
}

const apply = (m: Float64Array, [x, y, z]: Vec3): Vec3 => [
  m[0] * x + m[1] * y + m[2] * z,
  m[3] * x + m[4] * y + m[5] * z,
  m[6] * x + m[7] * y + m[8] * z,
];

/** The identity if the matrix is singular. */
export function inverseTranspose(m: Mat3): Mat3 {
  const inverse = cofactors(m).map((x) => x / determinant(m));
  return inverse.every(Number.isFinite) ? inverse : IDENTITY;
}
