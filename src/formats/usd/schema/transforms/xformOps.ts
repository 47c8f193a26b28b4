import { radians } from '../../../../math/angle.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { fromAxisAngle, IDENTITY, normalizeQuat, type Quat, toMatrix } from '../../../../math/quat.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import {
  attributeOf,
  LINEAR_TYPES,
  numberOf,
  numbersOf,
  sampleTimes,
  type TimeCode,
  tokensAt,
  valueAt,
} from '../../layer/attributes.ts';
import type { AttributeSpec, PrimSpec } from '../../layer/layer.ts';
import { cubicOpValues } from './cubicXformOps.ts';

/** One step of a prim's `xformOpOrder`. */
export interface XformOp {
  /** `translate`, `rotateXYZ`, … without namespace and suffix. */
  readonly kind: string;
  readonly inverted: boolean;
  readonly attribute: AttributeSpec;
  /** Cubic interpolation between samples instead of USD's linear one. */
  readonly cubic: boolean;
}

export interface LocalTransform {
  readonly ops: readonly XformOp[];
  /** `!resetXformStack!`: the parent's transform does not apply. */
  readonly resetsStack: boolean;
  /** Unsupported or missing names in `xformOpOrder`. */
  readonly unknown: readonly string[];
  /** Number of names if they exceed the maximum. */
  readonly tooMany?: number;
}

/** Maximum number of ops of a prim: a file with one prim could request millions at every time. */
export const MAX_OPS = 4096;

const RESET = '!resetXformStack!';
const INVERT = '!invert!';
const PREFIX = 'xformOp:';

/** The ops of a prim in authored order, the outermost first, from the last `!resetXformStack!`. */
export function transformOf(prim: PrimSpec, cubic = false): LocalTransform {
  const order = tokensAt(prim, 'xformOpOrder', undefined) ?? [];
  const reset = order.lastIndexOf(RESET);
  const count = order.length - reset - 1;
  const ops: XformOp[] = [];
  const unknown: string[] = [];
  for (const written of order.slice(reset + 1, reset + 1 + MAX_OPS)) {
    const op = opOf(prim, written, cubic);
    if (op) ops.push(op);
    else unknown.push(written);
  }
  return { ops, resetsStack: reset >= 0, unknown, ...(count > MAX_OPS && { tooMany: count }) };
}

function opOf(prim: PrimSpec, written: string, cubic: boolean): XformOp | undefined {
  const inverted = written.startsWith(INVERT);
  const name = inverted ? written.slice(INVERT.length) : written;
  const attribute = attributeOf(prim, name);
  const kind = name.startsWith(PREFIX) ? name.slice(PREFIX.length).split(':')[0] : '';
  return attribute && KINDS.test(kind) ? { kind, inverted, attribute, cubic } : undefined;
}

const KINDS = /^(translate[XYZ]?|scale[XYZ]?|rotate([XYZ]|XYZ|XZY|YXZ|YZX|ZXY|ZYX)|orient|transform)$/;

/** M in x_parent = M x_local at a time; ops without a value are the identity. */
export function localMatrix(ops: readonly XformOp[], time: TimeCode): mat4.Mat4 {
  let m: mat4.Mat4 | undefined;
  for (const op of ops) m = multiplied(m, opMatrix(op, opNumbers(op, time)));
  return m ?? mat4.IDENTITY;
}

const multiplied = (m: mat4.Mat4 | undefined, step: mat4.Mat4 | undefined): mat4.Mat4 | undefined =>
  m && step ? mat4.multiply(m, step) : (m ?? step);

/** A constant matrix or an animated op. */
type TransformStep = mat4.Mat4 | XformOp;

/** The ops with runs of constant ones multiplied into one matrix. */
export function collapsedSteps(ops: readonly XformOp[]): readonly TransformStep[] {
  const steps: TransformStep[] = [];
  for (const op of ops) {
    const last = steps.at(-1);
    if ((op.attribute.timeSamples?.times.length ?? 0) > 1) steps.push(op);
    else if (isMatrix(last)) steps[steps.length - 1] = mat4.multiply(last, localMatrix([op], 0));
    else steps.push(localMatrix([op], 0));
  }
  return steps;
}

const isMatrix = (step: TransformStep | undefined): step is mat4.Mat4 => Array.isArray(step);

/** `localMatrix` of the ops that the steps were made from, at a time code. */
export function stepProduct(steps: readonly TransformStep[], time: TimeCode): mat4.Mat4 {
  let m: mat4.Mat4 | undefined;
  for (const step of steps) m = multiplied(m, isMatrix(step) ? step : opMatrix(step, opNumbers(step, time)));
  return m ?? mat4.IDENTITY;
}

/** Sorted time codes of the ops' samples. */
export function opTimes(ops: readonly XformOp[]): Float64Array {
  return unionOfTimes(ops.map((op) => sampleTimes(op.attribute)));
}

/** Whether an op is constant or a linearly interpolated translation. */
export function isStraightOp({ kind, attribute, cubic }: XformOp): boolean {
  const samples = attribute.timeSamples;
  if (!samples || samples.times.length < 2) return true;
  const [first] = samples.values;
  const isNumber = numbersOf(first)?.length === 3 || (kind !== 'translate' && numberOf(first) !== undefined);
  const isLinear = LINEAR_TYPES.test(first.type) && samples.values.every(({ type }) => type === first.type);
  return !cubic && kind.startsWith('translate') && isNumber && isLinear;
}

/** The union of sorted lists of times. */
export const unionOfTimes = (lists: readonly Float64Array[]): Float64Array => lists.reduce(mergedTimes, NO_TIMES);

const NO_TIMES = new Float64Array(0);

function mergedTimes(a: Float64Array, b: Float64Array): Float64Array {
  if (a.length === 0 || b.length === 0) return a.length === 0 ? b : a;
  const out = new Float64Array(a.length + b.length);
  let count = 0;
  for (let i = 0, j = 0; i < a.length || j < b.length; count++) {
    const isFirst = j >= b.length || a[i] <= b[j];
    out[count] = isFirst ? a[i] : b[j];
    if (!isFirst || a[i] === b[j]) j++;
    if (isFirst) i++;
  }
  return out.slice(0, count);
}

function opNumbers({ kind, attribute, cubic }: XformOp, time: TimeCode): ArrayLike<number> | undefined {
  const curved = cubic ? cubicOpValues(kind, attribute, time) : undefined;
  if (curved) return curved;
  const value = valueAt(attribute, time);
  const single = numberOf(value);
  return single === undefined ? numbersOf(value) : [single];
}

function opMatrix(op: XformOp, numbers: ArrayLike<number> | undefined): mat4.Mat4 | undefined {
  if (!numbers) return undefined;
  const m = forwardMatrix(op.kind, numbers);
  return op.inverted && m ? mat4.invert(m) : m;
}

function forwardMatrix(kind: string, v: ArrayLike<number>): mat4.Mat4 | undefined {
  const axis = 'XYZ'.indexOf(kind.at(-1)!);
  if (kind === 'transform') return v.length === 16 ? mat4.transpose(Array.from(v)) : undefined;
  if (kind === 'orient') return v.length === 4 ? fromQuat(v) : undefined;
  if (kind === 'translate' || kind === 'scale')
    return v.length === 3 ? translationOrScale(kind, [v[0], v[1], v[2]]) : undefined;
  if (v.length === 1 && kind.startsWith('rotate')) return kind.length !== 7 ? undefined : rotation(axis, v[0]);
  if (v.length === 1)
    return translationOrScale(kind.slice(0, -1), onAxis(kind.startsWith('scale') ? 1 : 0, axis, v[0]));
  return v.length === 3 && kind.length === 9 ? eulerMatrix(kind.slice(6), v) : undefined;
}

const translationOrScale = (kind: string, [x, y, z]: Vec3): mat4.Mat4 =>
  kind === 'scale'
    ? [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1]
    : [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1];

function onAxis(rest: number, axis: number, value: number): Vec3 {
  const at = (i: number): number => (i === axis ? value : rest);
  return [at(0), at(1), at(2)];
}

/**
 * As GfRotation::SetQuat: the axis from the imaginary part, the angle from the real one, also if not unit. For unit
 * quaternions the arc cosine would lose half the digits of a small angle.
 */
function fromQuat(v: ArrayLike<number>): mat4.Mat4 {
  const q: Quat = [v[0], v[1], v[2], v[3]];
  return mat4.fromParts(
    toMatrix(Math.abs(Math.hypot(...q) - 1) < 1e-6 ? normalizeQuat(q) : fromAxisAndAngle(q)),
    [0, 0, 0],
  );
}

function fromAxisAndAngle([x, y, z, w]: Quat): Quat {
  if (Math.hypot(x, y, z) <= 1e-10) return IDENTITY;
  return fromAxisAngle([x, y, z], 2 * Math.acos(Math.max(-1, Math.min(1, w))));
}

/** Rotation about one axis [degrees]. */
function rotation(axis: number, degrees: number): mat4.Mat4 {
  const angle = radians(degrees);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  if (axis === 0) return [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1];
  if (axis === 1) return [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1];
  return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

/** `XYZ`: first about X, then Y, then Z. The angles are x, y, z for any order. */
function eulerMatrix(order: string, degrees: ArrayLike<number>): mat4.Mat4 {
  const about = (i: number): mat4.Mat4 => {
    const axis = 'XYZ'.indexOf(order[i]);
    return rotation(axis, degrees[axis]);
  };
  return mat4.multiply(about(2), mat4.multiply(about(1), about(0)));
}
