import * as mat4 from '../../../../math/mat4.ts';
import type { TimeCode } from '../../layer/attributes.ts';
import type { Layer } from '../../layer/layer.ts';
import { primAt } from '../../layer/query.ts';
import { MatrixCache } from './matrixCache.ts';
import { Memo } from './memo.ts';
import {
  collapsedSteps,
  isStraightOp,
  localMatrix,
  opTimes,
  stepProduct,
  transformOf,
  unionOfTimes,
  type XformOp,
} from './xformOps.ts';

/** Local-to-stage transform of a prim over time. */
export interface StageTransform {
  /** Time codes of the ops' samples; empty if static. */
  readonly times: Float64Array;
  /** Cost of `matrixAt` in ops and matrix products. */
  readonly cost: number;
  /** Only the translation changes, linearly between samples. */
  readonly isStraight?: boolean;
  /** The number of times is already bounded and does not count towards the scene's budget. */
  readonly isBudgeted?: boolean;
  /** x_stage = M x_local, in stage units. */
  matrixAt(time: TimeCode): mat4.Mat4;
}

export const ROOT_TRANSFORM: StageTransform = { times: new Float64Array(0), cost: 1, matrixAt: () => mat4.IDENTITY };

/** Cost of a cubic relative to an op. */
const CUBIC_COST = 3;

/** `isShared`: several frames are nested in it and mostly evaluate it at the same times. */
export function childTransform(parent: StageTransform, ops: readonly XformOp[], isShared = false): StageTransform {
  if (ops.length === 0) return parent;
  const own = opTimes(ops);
  const fixed = own.length === 0 ? localMatrix(ops, 0) : undefined;
  const steps = fixed ? [] : collapsedSteps(ops);
  const local = (time: TimeCode): mat4.Mat4 => fixed ?? stepProduct(steps, time);
  const times = unionOfTimes([parent.times, own]);
  if (times.length === 0) {
    const fixedToStage = mat4.multiply(parent.matrixAt(0), local(0));
    return { times, cost: 1, matrixAt: () => fixedToStage };
  }
  const each = ops.some((op) => op.cubic) ? CUBIC_COST : 1;
  const cost = parent.cost + Math.max(1, each * steps.length);
  const isStraight = (parent.times.length === 0 || parent.isStraight === true) && ops.every(isStraightOp);
  const within = (time: TimeCode): mat4.Mat4 => mat4.multiply(parent.matrixAt(time), local(time));
  const matrixAt = parent === ROOT_TRANSFORM ? local : within;
  return { times, cost, isStraight, matrixAt: isShared ? withMatrixCache(matrixAt, times.length) : matrixAt };
}

/** Caches matrices, because nested frames mostly evaluate their parent at the same times. */
function withMatrixCache(matrixAt: StageTransform['matrixAt'], times: number): StageTransform['matrixAt'] {
  let memory: MatrixCache | undefined;
  return (time) => {
    if (time === undefined) return matrixAt(time);
    memory ??= new MatrixCache(times);
    return memory.getOrCompute(time, matrixAt);
  };
}

/** The transform of `inner` within `outer`: outer × inner. */
export function nestedTransform(outer: StageTransform, inner: StageTransform): StageTransform {
  const times = unionOfTimes([outer.times, inner.times]);
  if (times.length > 0) {
    const cost = outer.cost + inner.cost;
    const isStraight = [outer, inner].every((frame) => frame.times.length === 0 || frame.isStraight === true);
    const alone = outer.times.length === 0 || inner.times.length === 0;
    const isCounted = [outer, inner].every((frame) => frame.times.length === 0 || frame.isBudgeted === true);
    const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.multiply(outer.matrixAt(time), inner.matrixAt(time));
    return { times, cost, isStraight: isStraight && alone, isBudgeted: isCounted, matrixAt };
  }
  const fixed = mat4.multiply(outer.matrixAt(0), inner.matrixAt(0));
  return { times, cost: 1, matrixAt: () => fixed };
}

/** The transform of the prim at a path. */
export function localToStageTransform(layer: Layer, path: string): StageTransform {
  if (path === '') return ROOT_TRANSFORM;
  const prim = primAt(layer, path);
  const transform = prim && transformOf(prim);
  const parent = transform?.resetsStack
    ? ROOT_TRANSFORM
    : localToStageTransform(layer, path.slice(0, path.lastIndexOf('/')));
  return transform ? childTransform(parent, transform.ops) : parent;
}

const IN_METERS = new Memo<StageTransform>();

/** The frame in metres; cached for moving frames. */
export function transformInMeters(frame: StageTransform, unit: number): StageTransform {
  if (unit === 1) return frame;
  const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.scaledUniformly(frame.matrixAt(time), unit);
  const made = (): StageTransform => ({ ...frame, matrixAt });
  // Static frames are not cached: the root's would never be released.
  return frame.times.length > 0 ? IN_METERS.getOrCreate(frame, [unit], made) : made();
}
