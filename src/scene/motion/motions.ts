import type { Motion, RigidMotion } from '../types.ts';
import { HYPERBOLIC_MOTION } from './kinds/hyperbolicMotion.ts';
import type { MotionKind, RigidMotionKind } from './kinds/motionKind.ts';
import { SAMPLED_MOTION } from './kinds/sampledMotion.ts';
import { SAMPLED_POINTS_MOTION } from './kinds/sampledPointsMotion.ts';
import { STATIC_MOTION } from './kinds/staticMotion.ts';
import { UNIFORM_MOTION } from './kinds/uniformMotion.ts';

type MotionKindOf<M extends Motion> = M extends RigidMotion ? RigidMotionKind<M> : MotionKind<M>;

/** The kinds of motion, a record each (docs/adr/0022-motion-kinds.md). */
const MOTIONS: { readonly [K in Motion['kind']]: MotionKindOf<Extract<Motion, { readonly kind: K }>> } = {
  static: STATIC_MOTION,
  uniform: UNIFORM_MOTION,
  hyperbolic: HYPERBOLIC_MOTION,
  sampled: SAMPLED_MOTION,
  'sampled-points': SAMPLED_POINTS_MOTION,
};

/** The scene's record of a motion's kind. */
export function motionKind<M extends RigidMotion>(motion: M): RigidMotionKind<M>;
export function motionKind<M extends Motion>(motion: M): MotionKind<M>;
export function motionKind(motion: Motion): MotionKind<Motion> {
  return MOTIONS[motion.kind];
}

/** The constants of a kind, by its name. */
export const motionFacts = (kind: Motion['kind']): Pick<MotionKind<Motion>, 'isStatic' | 'deforms' | 'approachesC'> =>
  MOTIONS[kind];
