import { linearPart, type Mat4 } from '../../../../math/mat4.ts';
import { msg } from '../../../../messages/message.ts';
import { MATRIX } from '../../../../scene/streaming/blendedPoints.ts';
import { DiagnosticList } from '../../../diagnostics/diagnosticLog.ts';
import { formatBytes } from '../../../diagnostics/inputError.ts';
import { BlendBudget } from '../../../read/blendBudget.ts';
import { jointPoses, ONE_JOINT } from '../../../read/blendedSkin.ts';
import type { OutlinedMesh } from '../../../read/jointOutline.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, sampleTimes } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { isActive, targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import type { PoseGrid } from '../geometry/primGeometry.ts';
import { budgetedSamples, reportUnfollowed } from '../placement/resampling.ts';
import { Memo } from '../transforms/memo.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { INDICES, jointsOf, type SkelBinding } from './binding.ts';
import { blendShapesOf } from './blendShapes.ts';
import { isLinearBlend, outlinedPoints } from './linearBlend.ts';
import { SKELETON } from './maybeSkinned.ts';
import type { Skeleton } from './skeleton.ts';

/** Digits to which spaces have the same proportions: instances may be rotated in f16. */
const SIZE_DIGITS = 3;

/** A mesh that is bound to a skeleton. */
export interface BoundMesh extends SkelBinding {
  readonly mesh: PrimSpec;
}

interface FollowedGrid extends PoseGrid {
  /** Greatest distance from a chord [m], in a frame of this size. */
  readonly error: number;
  readonly size: number;
}

interface TimedMesh extends OutlinedMesh {
  /** Time codes of its blend shapes. */
  readonly times: Float64Array;
}

/** The time grids of a stage's joints: one for each skeleton, or for a mesh that only blend shapes bend, and for each frame that moves them. */
export class JointGrids {
  private readonly context: StageContext;
  private readonly grids = new Memo<FollowedGrid>();
  private meshes: ReadonlyMap<string, readonly PrimSpec[]> | undefined;
  private budget: BlendBudget | undefined;

  constructor(context: StageContext) {
    this.context = context;
  }

  /** `times`: of the mesh that asks; `path`: its place in the scene. */
  gridIn(path: string, bound: BoundMesh, times: Float64Array, frame: StageTransform): PoseGrid {
    const isFixed = frame.times.length === 0;
    const { size, proportions } = sizeOf(frame.matrixAt(times[0]));
    const owner = bound.joints ? bound.skeleton : bound.mesh;
    const place = isFixed ? proportions : frame;
    const made = this.grids.getOrCreate(owner, [place], () => ({ ...this.makeGrid(path, bound, times, frame), size }));
    this.context.motionBudget.record(isFixed ? (made.error * size) / made.size : made.error);
    return made;
  }

  private makeGrid(
    path: string,
    bound: BoundMesh,
    own: Float64Array,
    frame: StageTransform,
  ): Omit<FollowedGrid, 'size'> {
    const { context } = this;
    const { skeleton, mesh } = bound;
    const joints = bound.joints && skeleton;
    const set = this.sets.get(joints ? skeleton.path : mesh.path) ?? [];
    const peers = set.flatMap((peer) => this.outlined(peer, skeleton, joints !== undefined) ?? []);
    const cost = frame.cost + (joints?.joints.length ?? 0) + peers.reduce((sum, { shapes }) => sum + shapes.length, 0);
    const times = [own, frame.times, joints?.animation?.times ?? NO_TIMES, ...peers.map((peer) => peer.times)];
    const knots = budgetedSamples(context, path, unionOfTimes(times), cost);
    const localsAt = (t: number): Float64Array => joints?.framesAt(t) ?? AT_REST;
    const framesAt = (t: number): Float64Array => carried(localsAt(t), frame.matrixAt(t));
    this.budget ??= new BlendBudget(this.sets.size);
    const grid = this.budget.follow({ meshes: peers, knots, cost, tolerance: context.bendTolerance, framesAt });
    if (!grid.isFollowed) reportUnfollowed(context, path, knots.length, grid);
    if (grid.isCoarse) {
      const message = msg`bends too much to hold in ${formatBytes(this.budget.bytes)}; it is sampled at ${grid.times.length} times only`;
      report(context, 'warning', 'usd.sample-budget', path, message);
    }
    const isInWorld = frame.times.length > 0;
    const at = isInWorld ? framesAt : localsAt;
    const poses = jointPoses(grid.times.length, joints?.tree ?? ONE_JOINT, (k, out) => out.set(at(grid.times[k])));
    return { times: grid.times, poses, isInWorld, error: grid.error };
  }

  /** A mesh as its joints see it; undefined if it is baked, or invalid. */
  private outlined(mesh: PrimSpec, skeleton: Skeleton, followsJoints: boolean): TimedMesh | undefined {
    // What is wrong with it is told where it is read.
    const context = { ...this.context, diagnostics: new DiagnosticList() };
    const points = numbersAt(mesh, 'points', context.startCode);
    if (!points || sampleTimes(attributeOf(mesh, 'points')).length > 0) return undefined;
    const joints = followsJoints ? jointsOf(context, mesh, skeleton, points.length / 3) : undefined;
    if (joints && 'template' in joints) return undefined;
    const shapes = blendShapesOf(context, mesh, points.length / 3, skeleton.source);
    if (joints?.isRigid && !shapes) return undefined;
    const binding = { skeleton, ...(joints && { joints }) };
    if (!isLinearBlend(binding, shapes, points.length / 3)) return undefined;
    return { ...outlinedPoints(points, binding, shapes), times: shapes?.times ?? NO_TIMES };
  }

  /** Meshes by the path of their skeleton, or by their own if they have only blend shapes. */
  private get sets(): ReadonlyMap<string, readonly PrimSpec[]> {
    if (this.meshes) return this.meshes;
    const found = new Map<string, PrimSpec[]>();
    for (const prim of this.context.layer.rootPrims.values()) collect(found, prim, NOT_BOUND);
    this.meshes = found;
    return found;
  }
}

/** What a prim inherits of its binding. */
interface InheritedBinding {
  readonly isInRoot: boolean;
  readonly skeleton: string | undefined;
  readonly hasInfluences: boolean;
}

const NOT_BOUND: InheritedBinding = { isInRoot: false, skeleton: undefined, hasInfluences: false };

function collect(found: Map<string, PrimSpec[]>, prim: PrimSpec, above: InheritedBinding): void {
  if (!isActive(prim)) return;
  const own = {
    isInRoot: above.isInRoot || prim.typeName === 'SkelRoot',
    skeleton: prim.properties.has(SKELETON) ? targetsOf(prim, SKELETON)[0] : above.skeleton,
    hasInfluences: above.hasInfluences || attributeOf(prim, INDICES) !== undefined,
  };
  const key = own.hasInfluences ? own.skeleton : prim.path;
  if (prim.typeName === 'Mesh' && own.isInRoot && own.skeleton !== undefined && key !== undefined) {
    const set = found.get(key) ?? [];
    found.set(key, set);
    set.push(prim);
  }
  for (const child of prim.children.values()) collect(found, child, own);
}

const NO_TIMES = new Float64Array(0);

/** The one frame of a mesh without joints. */
const AT_REST = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

/** Frames within another; at the end its origin, where the rest of incomplete weights is. */
function carried(frames: Float64Array, by: Mat4): Float64Array {
  const out = new Float64Array(frames.length + MATRIX);
  for (let j = 0; j < frames.length; j += MATRIX)
    for (let row = 0; row < MATRIX; row += 4)
      for (let c = 0; c < 4; c++)
        out[j + row + c] =
          by[row] * frames[j + c] +
          by[row + 1] * frames[j + 4 + c] +
          by[row + 2] * frames[j + 8 + c] +
          (c === 3 ? by[row + 3] : 0);
  for (let row = 0; row < MATRIX; row += 4) out[frames.length + row + 3] = by[row + 3];
  return out;
}

/** The greatest length of an axis; and a text that is the same for spaces which differ by a rotation and by their size. */
function sizeOf(m: Mat4): { readonly size: number; readonly proportions: string } {
  const l = linearPart(m);
  const product = (a: number, b: number): number => l[a] * l[b] + l[3 + a] * l[3 + b] + l[6 + a] * l[6 + b];
  const products = [product(0, 0), product(1, 1), product(2, 2), product(0, 1), product(0, 2), product(1, 2)];
  const square = Math.max(...products.map(Math.abs)) || 1;
  const proportions = products.map((x) => Math.round((x / square) * 10 ** SIZE_DIGITS)).join(' ');
  return { size: Math.sqrt(square), proportions };
}
