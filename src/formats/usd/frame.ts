import * as mat4 from '../../math/mat4.ts';
import { lowerSample, type TimeCode } from './attributes.ts';
import { primAt } from './context.ts';
import type { Layer } from './layer.ts';
import { localMatrix, opTimes, transformOf, unionOfTimes, type XformOp } from './xformOps.ts';

/** Where a prim's own axes are: its transform and those above it, at every time. */
export interface Frame {
  /** Codes at which the ops have samples; empty where nothing moves. */
  readonly times: Float64Array;
  /** How many ops and products of matrices `matrixAt` takes. */
  readonly cost: number;
  /** It does not turn, and goes straight from each of its times to the next. */
  readonly isStraight?: boolean;
  /** x_stage = M x_local, in stage units. */
  matrixAt(time: TimeCode): mat4.Mat4;
}

export const ROOT_FRAME: Frame = { times: new Float64Array(0), cost: 1, matrixAt: () => mat4.IDENTITY };

/** A cubic takes as long as so many ops. */
const CUBIC_COST = 3;

/** `isShared`: several things will ask for its matrices, mostly at the same times. */
export function childFrame(parent: Frame, ops: readonly XformOp[], isShared = false): Frame {
  if (ops.length === 0) return parent;
  const own = opTimes(ops);
  const fixed = own.length === 0 ? localMatrix(ops, 0) : undefined;
  const local = (time: TimeCode): mat4.Mat4 => fixed ?? localMatrix(ops, time);
  const times = unionOfTimes([parent.times, own]);
  if (times.length === 0) {
    const fixedToStage = mat4.multiply(parent.matrixAt(0), local(0));
    return { times, cost: 1, matrixAt: () => fixedToStage };
  }
  const each = ops.some((op) => op.cubic) ? CUBIC_COST : 1;
  const cost = parent.cost + (fixed ? 1 : each * ops.length);
  const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.multiply(parent.matrixAt(time), local(time));
  return { times, cost, matrixAt: isShared ? remembered(times, matrixAt) : matrixAt };
}

/** Frames of more samples than this remember none: 10 MB. */
const MOST_REMEMBERED = 2 ** 16;

/** At the times of the samples each matrix is made once. */
function remembered(times: Float64Array, matrixAt: Frame['matrixAt']): Frame['matrixAt'] {
  if (times.length > MOST_REMEMBERED) return matrixAt;
  const known: (mat4.Mat4 | undefined)[] = [];
  return (time) => {
    if (time === undefined) return matrixAt(time);
    const i = lowerSample(times, time);
    if (times[i] !== time) return matrixAt(time);
    known[i] ??= matrixAt(time);
    return known[i];
  };
}

/** Where the axes of `inner`, which is within `outer`, are. */
export function nestedFrame(outer: Frame, inner: Frame): Frame {
  const times = unionOfTimes([outer.times, inner.times]);
  if (times.length > 0) {
    const cost = outer.cost + inner.cost;
    const isStraight = [outer, inner].every((frame) => frame.times.length === 0 || frame.isStraight === true);
    const alone = outer.times.length === 0 || inner.times.length === 0;
    const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.multiply(outer.matrixAt(time), inner.matrixAt(time));
    return { times, cost, isStraight: isStraight && alone, matrixAt };
  }
  const fixed = mat4.multiply(outer.matrixAt(0), inner.matrixAt(0));
  return { times, cost: 1, matrixAt: () => fixed };
}

/** Of the prim at a path. */
export function frameOf(layer: Layer, path: string): Frame {
  if (path === '') return ROOT_FRAME;
  const prim = primAt(layer, path);
  const transform = prim && transformOf(prim);
  const parent = transform?.resetsStack ? ROOT_FRAME : frameOf(layer, path.slice(0, path.lastIndexOf('/')));
  return transform ? childFrame(parent, transform.ops) : parent;
}

/** The frame in metres. */
export function scaledFrame(frame: Frame, unit: number): Frame {
  const scale: mat4.Mat4 = [unit, 0, 0, 0, 0, unit, 0, 0, 0, 0, unit, 0, 0, 0, 0, 1];
  return { ...frame, matrixAt: (time) => mat4.multiply(scale, frame.matrixAt(time)) };
}
