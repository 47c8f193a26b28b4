import type { Vec3 } from '../../../math/vec3.ts';
import type { Motion, Pose, SampledMotion } from '../../../scene/types.ts';
import { double, doubles, type Lines, timeSamples } from './usdaText.ts';

/** How a prim is written. */
export interface WriteContext {
  readonly metersPerUnit: number;
  readonly codesPerSecond: number;
  /** It is inside a prim that has a transform of its own. */
  readonly nested: boolean;
}

/** How USD has a kind of motion. */
interface UsdMotion<M extends Motion> {
  /** Our own attributes: what USD has no name for. */
  slowlightLines(motion: M, placement: WriteContext): Lines;
  /** The transform of the prim. */
  transformLines(motion: M, placement: WriteContext): Lines;
}

const perUnit = (v: Vec3, { metersPerUnit }: WriteContext): string => doubles(v.map((x) => x / metersPerUnit));

/** Poses are the stage's: inside a prim with a transform, that one's does not count. */
function orderLine({ nested }: WriteContext, ...ops: string[]): string {
  const order = nested ? ['!resetXformStack!', ...ops] : ops;
  return `uniform token[] xformOpOrder = [${order.map((op) => `"${op}"`).join(', ')}]`;
}

export function poseLines({ position, orientation }: Pose, placement: WriteContext): Lines {
  return [
    `quatd xformOp:orient = ${quaternionText(orientation)}`,
    `double3 xformOp:translate = ${perUnit(position, placement)}`,
    orderLine(placement, 'xformOp:translate', 'xformOp:orient'),
  ];
}

function sampledLines({ times, poses }: SampledMotion, placement: WriteContext): Lines {
  const codes = times.map((t) => t * placement.codesPerSecond);
  const part = (i: number, from: number, to: number): number[] => Array.from(poses.subarray(7 * i + from, 7 * i + to));
  return [
    ...timeSamples('quatd xformOp:orient', codes, (i) => quaternionText(part(i, 3, 7))),
    ...timeSamples('double3 xformOp:translate', codes, (i) =>
      doubles(part(i, 0, 3).map((x) => x / placement.metersPerUnit)),
    ),
    orderLine(placement, 'xformOp:translate', 'xformOp:orient'),
  ];
}

const quaternionText = ([x, y, z, w]: readonly number[]): string => doubles([w, x, y, z]);

const nothing = (): Lines => [];
const posedLines = ({ pose }: { readonly pose: Pose }, placement: WriteContext): Lines => poseLines(pose, placement);

const USD_MOTIONS: { readonly [K in Motion['kind']]: UsdMotion<Extract<Motion, { readonly kind: K }>> } = {
  static: { slowlightLines: nothing, transformLines: posedLines },
  uniform: {
    slowlightLines: ({ velocity }, placement) => [
      'custom token slowlight:motion = "uniform"',
      `custom vector3d slowlight:velocity = ${perUnit(velocity, placement)}`,
    ],
    transformLines: posedLines,
  },
  hyperbolic: {
    slowlightLines: ({ properAcceleration, t0 }, placement) => [
      'custom token slowlight:motion = "hyperbolic"',
      `custom vector3d slowlight:properAcceleration = ${perUnit(properAcceleration, placement)}`,
      `custom double slowlight:t0 = ${double(t0)}`,
    ],
    transformLines: posedLines,
  },
  sampled: { slowlightLines: nothing, transformLines: sampledLines },
  'sampled-points': {
    slowlightLines: nothing,
    transformLines: ({ origin }, placement) => [
      `double3 xformOp:translate = ${perUnit(origin, placement)}`,
      orderLine(placement, 'xformOp:translate'),
    ],
  },
};

const usdMotion = (motion: Motion): UsdMotion<Motion> => USD_MOTIONS[motion.kind];

export const slowlightMotionLines = (motion: Motion, placement: WriteContext): Lines =>
  usdMotion(motion).slowlightLines(motion, placement);

export const motionLines = (motion: Motion, placement: WriteContext): Lines =>
  usdMotion(motion).transformLines(motion, placement);
