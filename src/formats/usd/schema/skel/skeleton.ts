import * as mat4 from '../../../../math/mat4.ts';
import { type Message, msg } from '../../../../messages/message.ts';
import type { JointTree } from '../../../../scene/streaming/blendedPoints.ts';
import { report } from '../../diagnostics.ts';
import { numbersAt, tokensAt } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { localToStageTransform, type StageTransform } from '../transforms/stageTransform.ts';
import { animationPrim, type JointAnimation, jointAnimationOf } from './animation.ts';

/** Maximum depth of the joint hierarchy. */
const MAX_DEPTH = 512;
/** Maximum number of cached matrix elements: all meshes of a skeleton request the same times. */
const MAX_CACHED = 2 ** 20;

/** A Skeleton prim with its animation. */
export class Skeleton {
  readonly path: string;
  readonly joints: readonly string[];
  /** Transform of skeleton space, in which skinned points are. */
  readonly transform: StageTransform;
  readonly animation: JointAnimation | undefined;
  /** The SkelAnimation prim; it may have only blend shape weights. */
  readonly source: PrimSpec | undefined;
  private readonly parents: Int32Array;
  /** Joint indices, parents before children. */
  private readonly order: readonly number[];
  private readonly rest: Float64Array | undefined;
  /** Bind space to the axes of each joint, three rows of four. */
  readonly inverseBind: Float64Array;
  private readonly poseCache = new Map<number, Float64Array>();

  constructor(
    parts: Pick<Skeleton, 'path' | 'joints' | 'transform' | 'animation' | 'source'>,
    tree: JointOrder,
    binds: BindPose,
  ) {
    this.path = parts.path;
    this.joints = parts.joints;
    this.transform = parts.transform;
    this.animation = parts.animation;
    this.source = parts.source;
    this.parents = tree.parents;
    this.order = tree.order;
    this.rest = binds.rest;
    this.inverseBind = binds.inverseBind;
  }

  /** Joint × inverse bind, three rows of four per joint: bind space to skeleton space. */
  matricesAt(time: number): Float64Array {
    const cached = this.poseCache.get(time);
    if (cached) return cached;
    const made = this.computed(time);
    if ((this.poseCache.size + 1) * made.length > MAX_CACHED) this.poseCache.clear();
    this.poseCache.set(time, made);
    return made;
  }

  /** From the axes of each joint to skeleton space, three rows of four; in a new array. */
  framesAt(time: number): Float64Array {
    const local = this.animation?.localsAt(time, this.rest) ?? this.rest!;
    const out = new Float64Array(local.length);
    for (const joint of this.order) {
      const parent = this.parents[joint];
      if (parent < 0) out.set(local.subarray(12 * joint, 12 * joint + 12), 12 * joint);
      else multiplyInto(out, joint, out, parent, local, joint);
    }
    return out;
  }

  /** The joints by the last parts of their paths. */
  get tree(): JointTree {
    return { names: this.joints.map((joint) => joint.slice(joint.lastIndexOf('/') + 1)), parents: this.parents };
  }

  private computed(time: number): Float64Array {
    const frames = this.framesAt(time);
    const out = new Float64Array(frames.length);
    for (const joint of this.order) multiplyInto(out, joint, frames, joint, this.inverseBind, joint);
    return out;
  }
}

interface JointOrder {
  readonly parents: Int32Array;
  readonly order: readonly number[];
}
interface BindPose {
  readonly rest: Float64Array | undefined;
  readonly inverseBind: Float64Array;
}

/** Reads a Skeleton prim; undefined, with a diagnostic, if it is invalid. */
export function readSkeleton(context: StageContext, prim: PrimSpec): Skeleton | undefined {
  const fail = (message: Message): undefined => {
    report(context, 'warning', 'usd.skeleton', prim.path, msg`${message}; its meshes stay as they are written`);
    return undefined;
  };
  const joints = tokensAt(prim, 'joints', undefined) ?? [];
  const source = animationPrim(context, prim);
  // A skeleton without joints may bring the weights of blend shapes.
  const hasShapes = source !== undefined && (tokensAt(source, 'blendShapes', undefined) ?? []).length > 0;
  if (joints.length === 0 && !hasShapes) return fail(msg`joints is empty`);
  const tree = treeOf(joints);
  if ('template' in tree) return fail(tree);
  const binds = joints.length > 0 ? numbersAt(prim, 'bindTransforms', undefined) : NO_MATRICES;
  if (binds?.length !== 16 * joints.length)
    return fail(msg`bindTransforms has ${(binds?.length ?? 0) / 16} matrices for ${joints.length} joints`);
  const unbind = inverses(binds);
  if (typeof unbind === 'number') return fail(msg`bindTransforms[${unbind}] has no inverse`);
  const rests = joints.length > 0 ? numbersAt(prim, 'restTransforms', undefined) : NO_MATRICES;
  const rest = rests?.length === 16 * joints.length && rests.every(Number.isFinite) ? columnMatrices(rests) : undefined;
  const animation = source && jointAnimationOf(context, source, joints);
  if (!rest && !animation?.isWhole)
    return fail(
      msg`restTransforms has ${(rests?.length ?? 0) / 16} usable matrices for ${joints.length} joints, and no animation moves all of them`,
    );
  const frame = localToStageTransform(context.layer, prim.path);
  return new Skeleton({ path: prim.path, joints, transform: frame, animation, source }, tree, {
    rest,
    inverseBind: unbind,
  });
}

const NO_MATRICES = new Float64Array(0);

/** A joint's parent is the nearest path above it that is a joint. */
function treeOf(joints: readonly string[]): JointOrder | Message {
  const places = new Map<string, number>();
  const depths = joints.map((joint) => joint.split('/', MAX_DEPTH + 1).length);
  for (const [j, joint] of joints.entries()) {
    if (depths[j] > MAX_DEPTH) return msg`joints[${j}] is more than ${MAX_DEPTH} joints deep`;
    if (places.has(joint)) return msg`joints names '${joint}' twice`;
    places.set(joint, j);
  }
  const parents = Int32Array.from(joints, (joint) => {
    for (let end = joint.lastIndexOf('/'); end > 0; end = joint.lastIndexOf('/', end - 1)) {
      const parent = places.get(joint.slice(0, end));
      if (parent !== undefined) return parent;
    }
    return -1;
  });
  const order = [...joints.keys()].sort((a, b) => depths[a] - depths[b]);
  return { parents, order };
}

/** Transposes 4 × 4 matrices for row vectors; returns their first three rows for column vectors. */
export function columnMatrices(written: NumberArray): Float64Array {
  const out = new Float64Array((written.length / 16) * 12);
  for (let m = 0; m < written.length / 16; m++)
    for (let r = 0; r < 3; r++) for (let c = 0; c < 4; c++) out[12 * m + 4 * r + c] = written[16 * m + 4 * c + r];
  return out;
}

/** Inverse matrices, or the index of the first singular one. */
function inverses(written: NumberArray): Float64Array | number {
  const out = new Float64Array((written.length / 16) * 12);
  for (let m = 0; m < written.length / 16; m++) {
    const inverse = mat4.invert(mat4.transpose(Array.from(written.subarray(16 * m, 16 * m + 16))));
    if (!inverse?.every(Number.isFinite)) return m;
    out.set(inverse.slice(0, 12), 12 * m);
  }
  return out;
}

/** out[i] = a[j] b[k], matrices of three rows of four. */
function multiplyInto(out: Float64Array, i: number, a: Float64Array, j: number, b: Float64Array, k: number): void {
  for (let r = 12 * j, o = 12 * i; r < 12 * j + 12; r += 4, o += 4) {
    const [x, y, z, w] = [a[r], a[r + 1], a[r + 2], a[r + 3]];
    for (let c = 0; c < 4; c++)
      out[o + c] = x * b[12 * k + c] + y * b[12 * k + 4 + c] + z * b[12 * k + 8 + c] + (c === 3 ? w : 0);
  }
}
