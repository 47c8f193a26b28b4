import { vec4 } from 'three/tsl';
import { scale } from '../../../math/vec3.ts';
import { oneMinusBetaSquared } from '../../../physics/lorentz/boost.ts';
import type { UniformMotion } from '../../../scene/types.ts';
import { linearEmission } from '../../../shaders/emission/linearEmission.ts';
import { type LightMotionKind, relativeAnchor } from './lightMotionKind.ts';

export const UNIFORM_MOTION: LightMotionKind<UniformMotion> = {
  sampleTexels: () => 0,
  write({ velocity }, _anchor, { c }) {
    const v = scale(velocity, 1 / c);
    return { motion: [...v, oneMinusBetaSquared(v)], w: 1, used: 0 };
  },
  emission({ motion: velocity }, d, lag) {
    const elapsed = linearEmission(relativeAnchor(d), velocity, vec4(0, 0, 0, lag)).toVar();
    return { offset: d.add(velocity.xyz.mul(elapsed)).toVar(), elapsed, velocity };
  },
};
