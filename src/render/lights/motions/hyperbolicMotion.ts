import { vec3 } from 'three/tsl';
import { length, normalize } from '../../../math/vec3.ts';
import type { HyperbolicMotion } from '../../../scene/types.ts';
import { hyperbolaEmission } from '../../../shaders/emission/hyperbolicEmission.ts';
import { rapidityFactor } from '../../geometry/observation.ts';
import { type LightMotionKind, relativeAnchor } from './lightMotionKind.ts';

export const HYPERBOLIC_MOTION: LightMotionKind<HyperbolicMotion> = {
  sampleTexels: () => 0,
  write: ({ properAcceleration: a, t0 }, { ahead }, observation) => ({
    motion: [...normalize(a, [1, 0, 0]), length(a) / (observation.c * observation.c)],
    w: rapidityFactor(a, t0, ahead, observation),
    used: 0,
  }),
  emission({ motion, w }, d, lag) {
    const anchor = relativeAnchor(d);
    // An event `lag` after the light cone is at (lag/w, lag·w) in the light-cone coordinates of `HyperbolaVertex`.
    const vertex = { across: vec3(0), plus: lag.div(w).toVar(), minus: lag.mul(w).toVar(), acceleration: motion.w };
    const { dx, s, velocity, exists } = hyperbolaEmission(anchor, motion, w, vertex);
    return { offset: dx.toVar(), elapsed: s.sub(lag), velocity: velocity.toVar(), exists };
  },
};
