import { invert, multiply as times3, transpose } from '../../../math/mat3.ts';
import { fromParts, isRigid, linearPart, type Mat4 } from '../../../math/mat4.ts';
import { multiply as after, fromMatrix, type Quat, toMatrix } from '../../../math/quat.ts';
import { add, scale, type Vec3, ZERO } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { boundingBox, boxRadius } from '../../../scene/bounds/bounds.ts';
import { flippedWinding } from '../../../scene/mesh/meshOps.ts';
import type { StretchedMesh } from '../../../scene/mesh/stretch.ts';
import { AdaptivePath, type SampledTimes, SamplingBudget } from '../../../scene/motion/adaptiveSampling.ts';
import {
  type JointPoses,
  MATRIX,
  makeBlendedNormals,
  makeBlendedPoints,
} from '../../../scene/streaming/blendedPoints.ts';
import type { Mesh, Motion, Pose, SampledMotion, StaticMotion } from '../../../scene/types.ts';
import { formatBytes } from '../../diagnostics/inputError.ts';
import { BlendBudget, MAX_HALVINGS, PATH_PROBES, POINTS_PER_CURVE } from '../../read/blendBudget.ts';
import { blendedSkin, jointPoses } from '../../read/blendedSkin.ts';
import { blendedPlaces, type OutlinedMesh } from '../../read/jointOutline.ts';
import { stretchedMesh } from '../../read/stretches.ts';
import type { GltfContext } from '../context.ts';
import type { Deformer } from './deform.ts';
import { type KeyTimes, keyTimesOf } from './keyTimes.ts';
import type { AnimatedTransform, NodeTransform } from './nodes.ts';
import type { Geometry } from './primitives.ts';

/** Maximum error of linear pieces, relative to half the object's diagonal. */
const RIGID_TOLERANCE = 1e-4;
const DEFORMING_TOLERANCE = 1e-3;
/** The same for frames without size: position, and axes 1 m long [m]. */
const FRAME_TOLERANCE = 1e-4;
/** Tolerance for a rotation matrix: files are single precision. */
const RIGIDITY = 1e-5;
/** For the paths of all that moves together [curves, each at one time]: about half a second. */
const MOTION_BUDGET = 2 ** 17;

/** A mesh with its motion, ready for a scene. */
export interface BakedMesh extends StretchedMesh {
  readonly motion: Motion;
}

/** Joints and weights of morph targets at the nodes of a time grid. */
interface JointGrid {
  /** At least one [s]. */
  readonly times: Float64Array;
  readonly poses: JointPoses;
  readonly shapeWeights: Float64Array;
}

/** Bakes the objects of one scene, within one budget of memory. */
export class Baker {
  private readonly context: GltfContext;
  private readonly motionBudget = new SamplingBudget(MOTION_BUDGET);
  private readonly blendBudget: BlendBudget;
  private readonly grids = new Map<string, JointGrid>();
  /** `bending`: number of skins and of meshes that bend by themselves, which share the budgets; `bytes`: most of joints. */
  constructor(context: GltfContext, bending: number, bytes?: number) {
    this.blendBudget = new BlendBudget(bending, bytes);
    this.context = context;
  }

  /** Largest error of a baked path [m]; undefined where nothing was baked. */
  get pathError(): number | undefined {
    const errors = [this.motionBudget.error, this.blendBudget.error].filter((error) => error !== undefined);
    return errors.length > 0 ? Math.max(...errors) : undefined;
  }

  /** A mesh moved only by its node: rigid for rotation and translation, else deforming. */
  bakeAffine(frame: AnimatedTransform, geometry: Geometry, deformer: Deformer): BakedMesh {
    const { transformAt } = frame;
    const knots = keyTimesOf(deformer.curves);
    const first = transformAt(knots.times[0] ?? 0);
    if (knots.times.length === 0) return this.placed(geometry.mesh, first);
    this.noteJumps(frame, knots);
    const corners = boxCorners(geometry.mesh.positions);
    const shape = cornerPaths(corners, transformAt);
    const tolerance = this.tolerance(RIGID_TOLERANCE) * boxRadius(shape(knots.times[0]));
    const times = this.followed({ path: frame.path, curves: deformer.curves }, knots, shape, tolerance);
    const poses = rigidPoses(transformAt, first, times);
    if (!poses) return this.bakePoints(frame, geometry, deformer);
    return { ...this.placed(geometry.mesh, first), motion: rigidMotion(times, poses) };
  }

  /**
   * A deforming mesh: its joints at the nodes of a time grid. `peersOf`: all meshes with the same joints, which share it.
   */
  bakePoints(
    frame: AnimatedTransform,
    geometry: Geometry,
    deformer: Deformer,
    peersOf: () => readonly OutlinedMesh[] = () => [],
  ): BakedMesh {
    const { mesh, morphs: shapes, skin } = geometry;
    const { times, poses, shapeWeights } = this.gridOf(frame, geometry, deformer, peersOf);
    const start = flatFrames(deformer.framesAt(times[0]));
    const origin = centerOf(blendedPlaces(outlined(geometry, deformer), start, times[0]));
    const rest = { positions: mesh.positions, normals: mesh.normals };
    const points = blendedSkin({
      rest,
      shapes,
      shapeWeights,
      poses,
      origin,
      binds: deformer.binds,
      ...(skin && deformer.isSkinned && { skin }),
    });
    const bent = { ...mesh, positions: makeBlendedPoints(points, 0), normals: makeBlendedNormals(points, 0) };
    const shown = deformer.isMirroredAt(times[0]) ? { ...bent, indices: flippedWinding(bent.indices) } : bent;
    if (times.length < 2) return { mesh: shown, motion: resting(origin) };
    return { mesh: shown, motion: { kind: 'sampled-points', times, origin, points } };
  }

  /** Motion of a camera or light; scale is ignored. */
  bakeFrame(frame: AnimatedTransform): StaticMotion | SampledMotion {
    const { transformAt } = frame;
    const knots = keyTimesOf(frame.curves);
    const poseAt = (t: number): Pose => poseOf(transformAt(t));
    if (knots.times.length < 2) return { kind: 'static', pose: poseAt(knots.times[0] ?? 0) };
    const axes = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
    const rigid = (t: number): NodeTransform => {
      const { position, orientation } = poseAt(t);
      return { matrix: fromParts(toMatrix(orientation), position), rotation: orientation };
    };
    const times = this.followed(frame, knots, cornerPaths(axes, rigid), FRAME_TOLERANCE);
    return rigidMotion(times, times.map(poseAt));
  }

  /** The mesh in a frame with the node's rotation; scale, shear and mirror are its stretch. */
  private placed(mesh: Mesh, placement: NodeTransform): BakedMesh {
    const linear = linearPart(placement.matrix);
    const stretch = times3(transpose(toMatrix(placement.rotation)), linear);
    return { ...stretchedMesh(mesh, stretch), motion: { kind: 'static', pose: poseOf(placement) } };
  }

  private tolerance(byDefault: number): number {
    return this.context.options.chordTolerance ?? byDefault;
  }

  /** Sample times of `shape` along its path, within the scene's budget. */
  private followed(
    { path, curves }: Pick<AnimatedTransform, 'path' | 'curves'>,
    knots: KeyTimes,
    shape: (t: number) => ArrayLike<number>,
    tolerance: number,
  ): number[] {
    const cost = 1 + curves.length + shape(knots.times[0]).length / 3 / POINTS_PER_CURVE;
    const how = { tolerance, fractions: PATH_PROBES, maxHalvings: MAX_HALVINGS, ramps: knots.jumps };
    const refined = new AdaptivePath(Float64Array.from(knots.times), shape, how);
    const sampled = this.motionBudget.sample(refined, cost);
    if (sampled.error > tolerance) this.noteWild(path, knots, sampled);
    return [...sampled.times];
  }

  private noteWild(path: string, knots: KeyTimes, { times, error, needed }: SampledTimes): void {
    const message = msg`moves too wildly between its ${knots.times.length} keys to be followed: about ${needed.toPrecision(2)} samples would be needed, ${times.length} are used, and paths are off by up to ${error.toPrecision(2)} m; export more keys`;
    this.context.notes.add('warning', 'gltf.resampling', path, message, { off: error });
  }

  private noteJumps({ path }: AnimatedTransform, { jumps }: KeyTimes): void {
    if (jumps.size === 0) return;
    const message = msg`jumps ${jumps.size} times (first at ${[...jumps].sort((a, b) => a - b)[0]} s); each jump is shown as a ramp of at most 1 ms, and may be faster than light`;
    this.context.notes.add('warning', 'gltf.jump', path, message);
  }

  /** The grid that all meshes with the same joints share; others have one of their own. */
  private gridOf(
    frame: AnimatedTransform,
    geometry: Geometry,
    deformer: Deformer,
    peersOf: () => readonly OutlinedMesh[],
  ): JointGrid {
    const known = deformer.skeleton !== undefined && this.grids.get(deformer.skeleton);
    if (known) return known;
    const { weightsAt } = deformer;
    const framesAt = (t: number): Float64Array => flatFrames(deformer.framesAt(t));
    const peers = deformer.skeleton === undefined ? [outlined(geometry, deformer)] : peersOf();
    const times = this.gridTimes(frame, deformer, peers, framesAt);
    const poses = jointPoses(times.length, deformer.tree, (k, out) => out.set(framesAt(times[k])));
    const shapes = geometry.morphs.length;
    const shapeWeights = new Float64Array(shapes * times.length);
    if (shapes > 0)
      times.forEach((t, k) => {
        shapeWeights.set(weightsAt(t).slice(0, shapes), shapes * k);
      });
    const grid = { times, poses, shapeWeights };
    if (deformer.skeleton !== undefined) this.grids.set(deformer.skeleton, grid);
    return grid;
  }

  /** Nodes at which the joints are kept. */
  private gridTimes(
    frame: AnimatedTransform,
    deformer: Deformer,
    meshes: readonly OutlinedMesh[],
    framesAt: (t: number) => Float64Array,
  ): Float64Array {
    const knots = keyTimesOf(deformer.curves);
    this.noteJumps(frame, knots);
    if (knots.times.length < 2) return Float64Array.of(knots.times[0] ?? 0);
    const grid = this.blendBudget.follow({
      meshes,
      knots: knots.times,
      ramps: knots.jumps,
      cost: deformer.curves.length,
      tolerance: this.tolerance(DEFORMING_TOLERANCE),
      framesAt,
    });
    if (!grid.isFollowed) this.noteWild(frame.path, knots, grid);
    if (grid.isCoarse) {
      const message = msg`bends too much to hold in ${formatBytes(this.blendBudget.bytes)}; it is sampled at ${grid.times.length} times only`;
      this.context.notes.add('warning', 'gltf.coarse', frame.path, message);
    }
    return grid.times;
  }
}

/** A mesh as its joints see it. */
export const outlined = (
  { mesh, morphs: shapes, skin }: Geometry,
  { binds, isSkinned, weightsAt }: Deformer,
): OutlinedMesh => ({ positions: mesh.positions, shapes, binds, weightsAt, ...(skin && isSkinned && { skin }) });

/** The first three rows of matrices; and none at the end, which is the world's origin. */
function flatFrames(frames: readonly Mat4[]): Float64Array {
  const out = new Float64Array(MATRIX * (frames.length + 1));
  for (const [j, matrix] of frames.entries()) for (let i = 0; i < MATRIX; i++) out[MATRIX * j + i] = matrix[i];
  return out;
}

const poseOf = ({ matrix, rotation }: NodeTransform): Pose => ({
  position: [matrix[3], matrix[7], matrix[11]],
  orientation: rotation,
});

/** Poses of a rigid motion; undefined if scaled or sheared along the way. */
function rigidPoses(
  placementAt: (t: number) => NodeTransform,
  first: NodeTransform,
  times: readonly number[],
): Pose[] | undefined {
  const undo = invert(linearPart(first.matrix));
  if (!undo) return undefined;
  const poses: Pose[] = [];
  for (const t of times) {
    const { matrix } = placementAt(t);
    const turn = times3(linearPart(matrix), undo);
    if (!isRigid(fromParts(turn, ZERO), RIGIDITY)) return undefined;
    poses.push({ position: [matrix[3], matrix[7], matrix[11]], orientation: after(fromMatrix(turn), first.rotation) });
  }
  return poses;
}

function rigidMotion(times: readonly number[], poses: readonly Pose[]): StaticMotion | SampledMotion {
  const same = (p: Pose): boolean => [...p.position, ...p.orientation].every((x, i) => Math.abs(x - at0[i]) < 1e-12);
  const at0 = [...poses[0].position, ...poses[0].orientation];
  if (times.length < 2 || poses.every(same)) return { kind: 'static', pose: poses[0] };
  const out = new Float64Array(7 * poses.length);
  let before = poses[0].orientation;
  for (const [i, { position, orientation }] of poses.entries()) {
    // q and −q are the same rotation; neighbours get the same sign for interpolation.
    const dot = orientation.reduce((sum, x, k) => sum + x * before[k], 0);
    before = dot < 0 ? (orientation.map((x) => -x) as unknown as Quat) : orientation;
    out.set([...position, ...before], 7 * i);
  }
  return { kind: 'sampled', times: Float64Array.from(times), poses: out };
}

/** For an affine motion the largest error in a box is at a corner. */
function cornerPaths(
  corners: readonly number[],
  placementAt: (t: number) => NodeTransform,
): (t: number) => Float64Array {
  return (t) => {
    const { matrix: m } = placementAt(t);
    const out = new Float64Array(corners.length);
    for (let i = 0; i < corners.length; i += 3)
      for (let k = 0; k < 3; k++)
        out[i + k] =
          m[4 * k] * corners[i] + m[4 * k + 1] * corners[i + 1] + m[4 * k + 2] * corners[i + 2] + m[4 * k + 3];
    return out;
  };
}

function boxCorners(positions: Float32Array): number[] {
  const box = boundingBox(positions) ?? { min: ZERO, max: ZERO };
  const ends = [box.min, box.max];
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [ends[i & 1][0], ends[(i >> 1) & 1][1], ends[i >> 2][2]]);
}

function centerOf(points: ArrayLike<number>): Vec3 {
  const box = boundingBox(points);
  return box ? scale(add(box.min, box.max), 0.5) : ZERO;
}

const resting = (position: Vec3): StaticMotion => ({ kind: 'static', pose: { position, orientation: [0, 0, 0, 1] } });
