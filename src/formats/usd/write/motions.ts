import { IDENTITY, type Mat4, transpose } from '../../../math/mat4.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import type { Lifetime, Motion, Pose, SampledMotion } from '../../../scene/types.ts';
import type { AttributeSpec } from '../layer/layer.ts';
import { attribute, custom, type Properties, sampled, uniform } from '../layer/specs.ts';
import { double, token, tokens, tuple } from '../layer/values.ts';

/** How a prim is written. */
export interface WriteContext {
  readonly metersPerUnit: number;
  readonly codesPerSecond: number;
  /** Of the animation [s]. */
  readonly startTime: number;
  /** It is inside a prim that has a transform of its own. */
  readonly nested: boolean;
  /** Prims with objects of their own are inside it. */
  readonly isParent: boolean;
  /** A prim around it says by our attributes when it exists, which it would inherit. */
  readonly inheritsLife: boolean;
  /** When it exists [s], in the order of time. */
  readonly lives: readonly Lifetime[];
}

/** How USD has a kind of motion. */
interface UsdMotion<M extends Motion> {
  /** Our own attributes: what USD has no name for. */
  slowlightProperties(motion: M, placement: WriteContext): Properties;
  /** The transform of the prim. */
  transformProperties(motion: M, placement: WriteContext): Properties;
}

const perUnit = (v: Vec3 | readonly number[], { metersPerUnit }: WriteContext) =>
  tuple(
    'double3',
    v.map((x) => x / metersPerUnit),
  );

/** Poses are the stage's: inside a prim with a transform, that one's does not count. */
export const orderOf = ({ nested }: WriteContext, ...ops: string[]) =>
  uniform('token[]', 'xformOpOrder', tokens(nested ? ['!resetXformStack!', ...ops] : ops));

export const TRANSLATE = 'xformOp:translate';
const ORIENT = 'xformOp:orient';

export const poseProperties = ({ position, orientation }: Pose, placement: WriteContext): Properties => [
  attribute('quatd', ORIENT, tuple('quatd', orientation)),
  attribute('double3', TRANSLATE, perUnit(position, placement)),
  orderOf(placement, TRANSLATE, ORIENT),
];

function sampledProperties({ times, poses }: SampledMotion, placement: WriteContext): Properties {
  const codes = times.map((t) => t * placement.codesPerSecond);
  const part = (i: number, from: number, to: number): number[] => Array.from(poses.subarray(7 * i + from, 7 * i + to));
  return [
    sampled('quatd', ORIENT, codes, (i) => tuple('quatd', part(i, 3, 7))),
    sampled('double3', TRANSLATE, codes, (i) => perUnit(part(i, 0, 3), placement)),
    orderOf(placement, TRANSLATE, ORIENT),
  ];
}

const nothing = (): Properties => [];
const posed = ({ pose }: { readonly pose: Pose }, placement: WriteContext): Properties =>
  poseProperties(pose, placement);

const USD_MOTIONS: { readonly [K in Motion['kind']]: UsdMotion<Extract<Motion, { readonly kind: K }>> } = {
  static: { slowlightProperties: nothing, transformProperties: posed },
  uniform: {
    slowlightProperties: ({ velocity }, placement) => [
      custom('token', 'slowlight:motion', token('uniform')),
      custom('vector3d', 'slowlight:velocity', perUnit(velocity, placement)),
    ],
    transformProperties: posed,
  },
  hyperbolic: {
    slowlightProperties: ({ properAcceleration, t0 }, placement) => [
      custom('token', 'slowlight:motion', token('hyperbolic')),
      custom('vector3d', 'slowlight:properAcceleration', perUnit(properAcceleration, placement)),
      custom('double', 'slowlight:t0', double(t0)),
    ],
    transformProperties: posed,
  },
  sampled: { slowlightProperties: nothing, transformProperties: sampledProperties },
  'sampled-points': {
    slowlightProperties: nothing,
    transformProperties: ({ origin }, placement) => [
      attribute('double3', TRANSLATE, perUnit(origin, placement)),
      orderOf(placement, TRANSLATE),
    ],
  },
};

const usdMotion = (motion: Motion): UsdMotion<Motion> => USD_MOTIONS[motion.kind];

export const slowlightMotion = (motion: Motion, placement: WriteContext): Properties =>
  usdMotion(motion).slowlightProperties(motion, placement);

export const transformOf = (motion: Motion, placement: WriteContext): Properties =>
  usdMotion(motion).transformProperties(motion, placement);

/** The transform of a prim, within which a map [m] is applied to its shape. */
export function withMap(properties: Properties, map: Mat4, { metersPerUnit }: WriteContext): Properties {
  if (map.every((x, i) => Math.abs(x - IDENTITY[i]) < 1e-12)) return properties;
  const rows = transpose(map).map((x, i) => (i >= 12 && i < 15 ? x / metersPerUnit : x));
  const op = 'xformOp:transform:shape';
  return [
    ...properties.flatMap((property) =>
      property.kind === 'attribute' && property.name === ORDER
        ? [attribute('matrix4d', op, tuple('matrix4d', rows)), { ...property, value: tokens([...opsOf(property), op]) }]
        : [property],
    ),
  ];
}

const ORDER = 'xformOpOrder';
const opsOf = ({ value }: AttributeSpec): readonly string[] => (value as { readonly data: readonly string[] }).data;
