import { toMatrix } from '../../../../math/quat.ts';
import { type Message, msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, sampleTimes, tokensAt } from '../../layer/attributes.ts';
import type { NumberArray, PrimSpec } from '../../layer/layer.ts';
import { primAt } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { unionOfTimes } from '../transforms/xformOps.ts';
import { nearestTarget } from './inheritedProperties.ts';

/** A SkelAnimation mapped to the joints of a skeleton. */
export interface JointAnimation {
  /** Time codes of the joints' samples. */
  readonly times: Float64Array;
  /** Every joint of the skeleton is animated. */
  readonly isWhole: boolean;
  /** Joint-to-parent matrices, three rows of four each; the rest pose for joints that are not animated. */
  localsAt(time: number, rest: Float64Array | undefined): Float64Array;
}

/** Numbers per joint. */
const JOINT_ATTRIBUTES = { translations: 3, rotations: 4, scales: 3 } as const;
type JointAttribute = keyof typeof JOINT_ATTRIBUTES;
const JOINT_ATTRIBUTE_NAMES = Object.keys(JOINT_ATTRIBUTES) as JointAttribute[];

/** The SkelAnimation that a skeleton is bound to; undefined if there is none. */
export function animationPrim(context: StageContext, skeleton: PrimSpec): PrimSpec | undefined {
  const path = nearestTarget(context.layer, skeleton.path, 'skel:animationSource');
  const prim = path === undefined ? undefined : primAt(context.layer, path);
  if (path !== undefined && prim?.typeName !== 'SkelAnimation') {
    report(
      context,
      'warning',
      'usd.skeleton',
      path,
      msg`skel:animationSource leads here, which is no SkelAnimation; it rests`,
    );
    return undefined;
  }
  return prim;
}

export function jointAnimationOf(
  context: StageContext,
  prim: PrimSpec,
  joints: readonly string[],
): JointAnimation | undefined {
  const moved = tokensAt(prim, 'joints', undefined) ?? [];
  if (moved.length === 0) return undefined;
  const problem = problemOf(context, prim, moved.length);
  if (problem) {
    report(context, 'warning', 'usd.skeleton', prim.path, msg`${problem}; its joints rest`);
    return undefined;
  }
  const places = new Map(moved.map((joint, i) => [joint, i]));
  const sources = Int32Array.from(joints, (joint) => places.get(joint) ?? -1);
  return {
    times: unionOfTimes(JOINT_ATTRIBUTE_NAMES.map((name) => sampleTimes(attributeOf(prim, name)))),
    isWhole: sources.every((s) => s >= 0),
    localsAt: (time, rest) => locals(prim, time, sources, rest),
  };
}

/** Why the joints cannot be animated, e.g. a sample without a value for each; undefined if they can. */
function problemOf(context: StageContext, prim: PrimSpec, joints: number): Message | undefined {
  for (const name of JOINT_ATTRIBUTE_NAMES) {
    const attribute = attributeOf(prim, name);
    const times = attribute?.timeSamples?.times ?? [];
    for (const time of times.length > 0 ? times : [context.startCode]) {
      const values = numbersAt(prim, name, time);
      const what = times.length > 0 ? msg`${name} at time ${time}` : name;
      if (values?.length !== joints * JOINT_ATTRIBUTES[name])
        return msg`${what} has ${(values?.length ?? 0) / JOINT_ATTRIBUTES[name]} values for ${joints} joints`;
      if (!values.every(Number.isFinite)) return msg`${what} holds what is no finite number`;
    }
  }
  return undefined;
}

function locals(prim: PrimSpec, time: number, sources: Int32Array, rest: Float64Array | undefined): Float64Array {
  const out = rest ? rest.slice() : new Float64Array(12 * sources.length);
  const [t, q, s] = JOINT_ATTRIBUTE_NAMES.map((name) => numbersAt(prim, name, time)!);
  for (let joint = 0; joint < sources.length; joint++) {
    const from = sources[joint];
    if (from >= 0) jointMatrixInto(out, 12 * joint, t, q, s, from);
  }
  return out;
}

/** Scale, then rotation, then translation. */
function jointMatrixInto(
  out: Float64Array,
  at: number,
  t: NumberArray,
  q: NumberArray,
  s: NumberArray,
  i: number,
): void {
  const turn = toMatrix([q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]]);
  for (let r = 0; r < 3; r++) {
    for (let c = 0; c < 3; c++) out[at + 4 * r + c] = turn[3 * r + c] * s[3 * i + c];
    out[at + 4 * r + 3] = t[3 * i + r];
  }
}
