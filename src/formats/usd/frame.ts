import * as mat4 from '../../math/mat4.ts';
import type { TimeCode } from './attributes.ts';
import { primAt } from './context.ts';
import type { Layer } from './layer.ts';
import { MatrixMemory } from './matrixMemory.ts';
import { Once } from './once.ts';
import {
  isStraightOp,
  localMatrix,
  opTimes,
  productOf,
  stepsOf,
  transformOf,
  unionOfTimes,
  type XformOp,
} from './xformOps.ts';

/** Where a prim's own axes are: its transform and those above it, at every time. */
export interface Frame {
  /** Codes at which the ops have samples; empty where nothing moves. */
  readonly times: Float64Array;
  /** How many ops and products of matrices `matrixAt` takes. */
  readonly cost: number;
  /** It does not turn, and goes straight from each of its times to the next. */
  readonly isStraight?: boolean;
  /** Its times are bounded where they come from, and take none of the scene's. */
  readonly isCounted?: boolean;
  /** x_stage = M x_local, in stage units. */
  matrixAt(time: TimeCode): mat4.Mat4;
}

export const ROOT_FRAME: Frame = { times: new Float64Array(0), cost: 1, matrixAt: () => mat4.IDENTITY };

/** A cubic takes as long as so many ops. */
const CUBIC_COST = 3;

/** `isShared`: several frames are within it, and ask for its matrices mostly at the same times. */
export function childFrame(parent: Frame, ops: readonly XformOp[], isShared = false): Frame {
  if (ops.length === 0) return parent;
  const own = opTimes(ops);
  const fixed = own.length === 0 ? localMatrix(ops, 0) : undefined;
  const steps = fixed ? [] : stepsOf(ops);
  const local = (time: TimeCode): mat4.Mat4 => fixed ?? productOf(steps, time);
  const times = unionOfTimes([parent.times, own]);
  if (times.length === 0) {
    const fixedToStage = mat4.multiply(parent.matrixAt(0), local(0));
    return { times, cost: 1, matrixAt: () => fixedToStage };
  }
  const each = ops.some((op) => op.cubic) ? CUBIC_COST : 1;
  const cost = parent.cost + Math.max(1, each * steps.length);
  const isStraight = (parent.times.length === 0 || parent.isStraight === true) && ops.every(isStraightOp);
  const within = (time: TimeCode): mat4.Mat4 => mat4.multiply(parent.matrixAt(time), local(time));
  const matrixAt = parent === ROOT_FRAME ? local : within;
  return { times, cost, isStraight, matrixAt: isShared ? remembered(matrixAt, times.length) : matrixAt };
}

/** Matrices are made once: what is carried along is looked at where its carrier is, mostly at the same times. */
function remembered(matrixAt: Frame['matrixAt'], times: number): Frame['matrixAt'] {
  let memory: MatrixMemory | undefined;
  return (time) => {
    if (time === undefined) return matrixAt(time);
    memory ??= new MatrixMemory(times);
    return memory.at(time, matrixAt);
  };
}

/** Where the axes of `inner`, which is within `outer`, are. */
export function nestedFrame(outer: Frame, inner: Frame): Frame {
  const times = unionOfTimes([outer.times, inner.times]);
  if (times.length > 0) {
    const cost = outer.cost + inner.cost;
    const isStraight = [outer, inner].every((frame) => frame.times.length === 0 || frame.isStraight === true);
    const alone = outer.times.length === 0 || inner.times.length === 0;
    const isCounted = [outer, inner].every((frame) => frame.times.length === 0 || frame.isCounted === true);
    const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.multiply(outer.matrixAt(time), inner.matrixAt(time));
    return { times, cost, isStraight: isStraight && alone, isCounted, matrixAt };
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

const IN_METRES = new Once<Frame>();

/** The frame in metres; the same one for one that moves. */
export function scaledFrame(frame: Frame, unit: number): Frame {
  if (unit === 1) return frame;
  const matrixAt = (time: TimeCode): mat4.Mat4 => mat4.enlarged(frame.matrixAt(time), unit);
  const made = (): Frame => ({ ...frame, matrixAt });
  // What rests is not kept: the root's frame is there for ever.
  return frame.times.length > 0 ? IN_METRES.of(frame, [unit], made) : made();
}
