import { cross, dFdx, dFdy, Fn, length, mix, sqrt } from 'three/tsl';
import { observerDoppler } from '../../shaders/kinematics/observerDoppler.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { ColorPipeline } from '../color/radiance.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';

/** Radiance of the background in the direction `nPrime` of the observer's frame (unit vector, on the world axes carried by the boost). */
export const backgroundRadiance = (
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  nPrime: Vec3,
): Vec3 =>
  Fn(() => {
    const { u, gamma, boosted, footprint } = uniforms;
    const n = mix(nPrime, unaberrate(nPrime, u, gamma), boosted)
      .normalize()
      .toVar();
    const D: Float = observerDoppler(n, u, gamma).toVar();
    const accumulator = pipeline(D, uniforms);
    const angle = sqrt(length(cross(dFdx(n), dFdy(n))))
      .mul(footprint)
      .toVar();
    environment.addBackground({ n, angle }, uniforms, accumulator);
    return accumulator.total();
  })();
