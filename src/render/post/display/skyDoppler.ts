import { float, mix } from 'three/tsl';
import { observerDoppler } from '../../../shaders/kinematics/observerDoppler.ts';
import { unaberrate } from '../../../shaders/kinematics/unaberrate.ts';
import type { Float } from '../../../shaders/types.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { pixelDirection } from '../../lenses/pixelDirection.ts';

/** D of the sky at this pixel, which is at rest in the world; 1 in views without light. */
export function skyDoppler(uniforms: FrameUniforms): Float {
  const { u, gamma, boosted, boostLight } = uniforms;
  const nPrime = pixelDirection(uniforms).toVar();
  const n = mix(nPrime, unaberrate(nPrime, u, gamma), boosted).normalize();
  return mix(float(1), observerDoppler(n, u, gamma), boostLight);
}
