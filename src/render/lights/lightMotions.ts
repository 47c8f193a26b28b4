import type { RigidMotion } from '../../scene/types.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { HYPERBOLIC_MOTION } from './motions/hyperbolicMotion.ts';
import type { LightEmissionEvent, LightMotionKind, MovingTexels } from './motions/lightMotionKind.ts';
import { SAMPLED_MOTION } from './motions/sampledMotion.ts';
import { STATIC_MOTION } from './motions/staticMotion.ts';
import { UNIFORM_MOTION } from './motions/uniformMotion.ts';

/** How the lights of each kind of motion are held on the GPU. */
const LIGHT_MOTIONS: {
  readonly [K in RigidMotion['kind']]: LightMotionKind<Extract<RigidMotion, { readonly kind: K }>>;
} = {
  static: STATIC_MOTION,
  uniform: UNIFORM_MOTION,
  hyperbolic: HYPERBOLIC_MOTION,
  sampled: SAMPLED_MOTION,
};

export const lightMotionKind = ({ kind }: Pick<RigidMotion, 'kind'>): LightMotionKind<RigidMotion> =>
  LIGHT_MOTIONS[kind];

/** How a light moves, relative to one event of it, its anchor (lightTable.ts). */
export interface LightMotion {
  readonly kind: RigidMotion['kind'];
  /** Absent at rest. */
  readonly moving?: MovingTexels;
}

/**
 * The event at which a light emits what reaches a surface event. `d`: surface → the light's anchor [m]; `lag` [m of light]: how much later the anchor is
 * than the surface's past light cone, 0 where light takes no time. The functions that intersect the world line of a vertex with the observer's light cone
 * intersect the light's with that of the surface.
 */
export function lightEmissionEvent(motion: LightMotion, d: Vec3, lag: Float | undefined): LightEmissionEvent {
  const { emission } = lightMotionKind(motion);
  if (!emission || !motion.moving || !lag) return { offset: d, ...(lag && { elapsed: lag.negate() }) };
  return emission(motion.moving, d, lag);
}
