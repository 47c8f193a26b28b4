import * as mat4 from '../../../../math/mat4.ts';
import { msg } from '../../../../messages/message.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { blendMatrices, type SkinInfluences } from '../../../read/skinning.ts';
import { report } from '../../diagnostics.ts';
import { numbersAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { LinearBlend } from '../geometry/primGeometry.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { type SkelBinding, Skeletons } from './binding.ts';
import { type BlendShapes, blendShapesOf } from './blendShapes.ts';
import { DualQuaternionBlend, inverseTranspose, jointDualQuaternions } from './dualQuaternions.ts';
import { JointGrids } from './jointGrids.ts';
import { bindsOf, influencesOf, isLinearBlend, restShapes } from './linearBlend.ts';

/** Deformation of a mesh by a skeleton and blend shapes. */
export interface Skin {
  /** Time codes of samples of joints, weights or points. */
  readonly times: Float64Array;
  /** Transform of the space of its points; absent: the mesh's own. */
  readonly transform?: StageTransform;
  /** All points move alike, by `transform` alone. */
  readonly isRigid: boolean;
  /** Cost of a pose in transform evaluations. */
  readonly cost: number;
  /** 3 numbers for each of the requested points, or for all. */
  pointsAt(time: number, which?: ArrayLike<number>): Float64Array;
  /** The same by its joints, for vertices that are points of the mesh; undefined if it is no linear blend, or too large. */
  blendOf(mesh: Mesh, vertices: VertexOrigins): LinearBlend | undefined;
  /** Vertex normals deformed from `rest` (3 per vertex); undefined if they have to be computed from the points. */
  normalsAt(time: number, rest: Float32Array, pointOfVertex: ArrayLike<number>): Float32Array | undefined;
}

/** Where the vertices of a mesh come from. */
export interface VertexOrigins {
  readonly pointOfVertex: ArrayLike<number>;
  /** If not, their normals are those of the faces. */
  readonly areNormalsAuthored: boolean;
}

/** Reads the skins of a stage's meshes. */
export class Skins {
  private readonly context: StageContext;
  private readonly skeletons: Skeletons;
  private readonly grids: JointGrids;

  constructor(context: StageContext) {
    this.context = context;
    this.grids = new JointGrids(context);
    this.skeletons = new Skeletons(context);
  }

  /** The transform of a shape that follows joints as a whole; undefined if it follows none, or, with a diagnostic, if its points would follow different ones. */
  frameOf(shape: PrimSpec): StageTransform | undefined {
    const points = numbersAt(shape, 'points', this.context.startCode);
    const binding = this.skeletons.bindingOf(shape, points && points.length / 3);
    if (!binding?.joints) return undefined;
    const { context } = this;
    if (binding.joints.isRigid)
      return commonFrame(new SkinDeformer(context, shape, false, binding, undefined), binding);
    const message = msg`its points follow different joints, which is read of meshes only; these ${shape.typeName} stay as they are written`;
    report(context, 'warning', 'usd.skin', shape.path, message);
    return undefined;
  }

  /** Undefined if nothing deforms the mesh. */
  skinOf(mesh: PrimSpec, points: { readonly count: number; readonly times: Float64Array }): Skin | undefined {
    const { context } = this;
    const binding = this.skeletons.bindingOf(mesh, points.count);
    if (!binding) return undefined;
    const { skeleton } = binding;
    const shapes = blendShapesOf(context, mesh, points.count, skeleton.source);
    if (!binding.joints && !shapes) return undefined;
    const jointTimes = binding.joints ? (skeleton.animation?.times ?? []) : [];
    const bend = new SkinDeformer(context, mesh, points.times.length > 0, binding, shapes);
    const isLinear = binding.joints?.method === 'classicLinear' || binding.joints?.influences.perPoint === 1;
    if (binding.joints?.isRigid && isLinear && !shapes && points.times.length === 0) return rigidSkin(bend, binding);
    const times = unionOfTimes([points.times, Float64Array.from(jointTimes), shapes?.times ?? new Float64Array(0)]);
    return {
      times,
      ...(binding.joints ? { transform: skeleton.transform } : {}),
      isRigid: false,
      cost: (binding.joints ? skeleton.joints.length : 0) + (shapes?.cost ?? 0),
      pointsAt: (time, which) => bend.pointsAt(time, which),
      normalsAt: (time, rest, pointOfVertex) => bend.normalsAt(time, rest, pointOfVertex),
      blendOf: (drawn, { pointOfVertex, areNormalsAuthored }) => {
        if (points.times.length > 0 || !isLinearBlend(binding, shapes, pointOfVertex.length)) return undefined;
        const skin = influencesOf(binding, pointOfVertex);
        return {
          rest: { positions: drawn.positions, normals: drawn.normals },
          shapes: restShapes(drawn, shapes, pointOfVertex, areNormalsAuthored),
          binds: bindsOf(binding),
          ...(skin && { skin }),
          shapeWeightsAt: (time) => shapes?.partWeightsAt(time) ?? [],
          gridIn: (path, frame) => this.grids.gridIn(path, { ...binding, mesh }, times, frame),
        };
      },
    };
  }
}

/** Where all points are, if they move alike. */
function commonFrame(bend: SkinDeformer, { skeleton }: SkelBinding): StageTransform {
  const { transform, animation } = skeleton;
  const matrixAt = (time: number): mat4.Mat4 => mat4.multiply(transform.matrixAt(time), bend.frameAt(time));
  const times = unionOfTimes([transform.times, animation?.times ?? new Float64Array(0)]);
  const start = bend.context.startCode;
  const fixed = times.length === 0 ? matrixAt(start) : undefined;
  return {
    times,
    cost: transform.cost + skeleton.joints.length,
    matrixAt: (time) => fixed ?? matrixAt(time ?? start),
  };
}

function rigidSkin(bend: SkinDeformer, binding: SkelBinding): Skin {
  const start = bend.context.startCode;
  return {
    times: new Float64Array(0),
    transform: commonFrame(bend, binding),
    isRigid: true,
    cost: 0,
    pointsAt: () => Float64Array.from(numbersAt(bend.mesh, 'points', start)!),
    normalsAt: (_, rest) => rest,
    blendOf: () => undefined,
  };
}

/** One matrix for all points. */
const ALONE: SkinInfluences = { perPoint: 1, joints: [0], weights: [1] };

class SkinDeformer {
  readonly context: StageContext;
  readonly mesh: PrimSpec;
  /** The points have time samples. */
  private readonly moves: boolean;
  private readonly binding: SkelBinding;
  private readonly shapes: BlendShapes | undefined;

  constructor(
    context: StageContext,
    mesh: PrimSpec,
    moves: boolean,
    binding: SkelBinding,
    shapes: BlendShapes | undefined,
  ) {
    this.moves = moves;
    this.context = context;
    this.mesh = mesh;
    this.binding = binding;
    this.shapes = shapes;
  }

  /** Mesh space to skeleton space per joint, three rows of four. */
  boundAt(time: number): Float64Array {
    const { skeleton, joints } = this.binding;
    const matrices = skeleton.matricesAt(time);
    const out = new Float64Array(matrices.length);
    const g = joints!.geomBind;
    for (let r = 0; r < matrices.length; r += 4)
      for (let c = 0; c < 4; c++)
        out[r + c] =
          matrices[r] * g[c] +
          matrices[r + 1] * g[4 + c] +
          matrices[r + 2] * g[8 + c] +
          (c === 3 ? matrices[r + 3] : 0);
    return out;
  }

  pointsAt(time: number, which?: ArrayLike<number>): Float64Array {
    const all = numbersAt(this.mesh, 'points', this.moves ? time : this.context.startCode)!;
    const out = which ? new Float64Array(3 * which.length) : Float64Array.from(all);
    if (which)
      for (let i = 0; i < which.length; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = all[3 * which[i] + k];
    this.shapes?.addTo(out, 'points', time, which);
    const { joints } = this.binding;
    if (joints) this.carry(out, time, joints.isRigid ? () => 0 : (i) => (which ? which[i] : i));
    return out;
  }

  /** Mesh space to skeleton space of points that have all the same influences: where the origin and the tips of the axes are. */
  frameAt(time: number): mat4.Mat4 {
    const at = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
    this.carry(at, time, () => 0);
    const row = (k: number): number[] => [at[3 + k] - at[k], at[6 + k] - at[k], at[9 + k] - at[k], at[k]];
    return [...row(0), ...row(1), ...row(2), 0, 0, 0, 1];
  }

  private carry(out: Float64Array, time: number, pointOf: (i: number) => number): void {
    const { influences, method } = this.binding.joints!;
    if (method === 'classicLinear') skinPoints(out, this.boundAt(time), influences, pointOf);
    else this.carryDual(out, time, influences, pointOf);
  }

  private carryDual(out: Float64Array, time: number, influences: SkinInfluences, pointOf: (i: number) => number): void {
    const { skeleton, joints } = this.binding;
    skinPoints(out, joints!.geomBind, ALONE, () => 0);
    const blend = new DualQuaternionBlend(jointDualQuaternions(skeleton.matricesAt(time)), influences, 'points');
    for (let i = 0; i < out.length / 3; i++) {
      blend.at(pointOf(i));
      out.set(blend.point([out[3 * i], out[3 * i + 1], out[3 * i + 2]]), 3 * i);
    }
  }

  normalsAt(time: number, rest: Float32Array, pointOfVertex: ArrayLike<number>): Float32Array | undefined {
    const { joints } = this.binding;
    if (this.shapes && !this.shapes.haveNormals) return undefined;
    const out = Float64Array.from(rest);
    this.shapes?.addTo(out, 'normals', time, pointOfVertex);
    if (!joints) return normalized(out);
    const pointOf = joints.isRigid ? () => 0 : (i: number) => pointOfVertex[i];
    if (joints.method === 'classicLinear' && joints.isRigid) {
      const matrix = new Float64Array(12);
      blendMatrices(matrix, this.boundAt(time), 12, joints.influences, 0);
      skinNormals(out, inverseTransposes(matrix), ALONE, pointOf);
    } else if (joints.method === 'classicLinear') {
      skinNormals(out, inverseTransposes(this.boundAt(time)), joints.influences, pointOf);
    } else {
      skinNormals(out, inverseTransposes(joints.geomBind), ALONE, () => 0);
      const blend = new DualQuaternionBlend(
        jointDualQuaternions(this.binding.skeleton.matricesAt(time)),
        joints.influences,
        'normals',
      );
      for (let i = 0; i < out.length / 3; i++) {
        blend.at(pointOf(i));
        out.set(blend.normal([out[3 * i], out[3 * i + 1], out[3 * i + 2]]), 3 * i);
      }
    }
    return normalized(out);
  }
}

function skinPoints(
  points: Float64Array,
  matrices: Float64Array,
  influences: SkinInfluences,
  pointOf: (i: number) => number,
): void {
  const m = new Float64Array(12);
  for (let i = 0; i < points.length; i += 3) {
    blendMatrices(m, matrices, 12, influences, pointOf(i / 3));
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    points[i] = m[0] * x + m[1] * y + m[2] * z + m[3];
    points[i + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
    points[i + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
  }
}

/** As UsdSkel: blends the joints' inverse transposes instead of inverting the blend, unless all points follow the same. */
function skinNormals(
  normals: Float64Array,
  matrices: Float64Array,
  influences: SkinInfluences,
  pointOf: (i: number) => number,
): void {
  const m = new Float64Array(9);
  for (let i = 0; i < normals.length; i += 3) {
    blendMatrices(m, matrices, 9, influences, pointOf(i / 3));
    const [x, y, z] = [normals[i], normals[i + 1], normals[i + 2]];
    for (let r = 0; r < 3; r++) normals[i + r] = m[3 * r] * x + m[3 * r + 1] * y + m[3 * r + 2] * z;
  }
}

/** Inverse transposes, 9 numbers each, of matrices of three rows of four. */
function inverseTransposes(matrices: Float64Array): Float64Array {
  const out = new Float64Array((matrices.length / 12) * 9);
  for (let j = 0; j < matrices.length / 12; j++) {
    const m = matrices.subarray(12 * j, 12 * j + 12);
    const linear = [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];
    out.set(inverseTranspose(linear), 9 * j);
  }
  return out;
}

function normalized(normals: Float64Array): Float32Array {
  const out = new Float32Array(normals.length);
  for (let i = 0; i < normals.length; i += 3) {
    const l = Math.sqrt(normals[i] ** 2 + normals[i + 1] ** 2 + normals[i + 2] ** 2);
    if (!(l > 0)) out[i + 2] = 1;
    else for (let k = i; k < i + 3; k++) out[k] = normals[k] / l;
  }
  return out;
}
