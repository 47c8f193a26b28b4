import { clamp, dot, exp, float, length, mix, pow, select, smoothstep, vec4 } from 'three/tsl';
import { SKY_SHAPE } from '../../scene/lights/skyGradient.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { singleStep } from './effect.ts';

/** `skyBackground` of src/reference/post/effects/. */
export const skyBackground = singleStep((frame) => {
  const [brightness, curve, fade, opacity] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const sky = gradientSky(frame.uniforms, dot(frame.direction(), frame.uniforms.zenith).toVar(), curve).mul(brightness);
  const behind = exp(length(frame.event(frame.pixel)).div(fade).negate()).oneMinus();
  const faded = select(fade.greaterThan(0), behind, 0);
  const amount = select(frame.hasSurface(frame.pixel), faded, float(1)).mul(opacity);
  return vec4(mix(here.rgb, sky, amount), here.w);
});

function gradientSky(colors: FrameUniforms, height: Float, curve: Float): Vec3 {
  const { dim, haze, seam } = SKY_SHAPE;
  const { skyZenith: zenith, skyHorizon: horizon, skyGround: ground } = colors;
  const above = mix(horizon, zenith, pow(clamp(height, 0, 1), curve));
  const below = mix(horizon.mul(dim), ground, smoothstep(0, haze, height.negate()));
  return mix(below, above, smoothstep(-seam, seam, height));
}
