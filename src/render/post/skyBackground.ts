import { clamp, dot, exp, float, length, mix, pow, select, smoothstep, vec4 } from 'three/tsl';
import { SKY_SHAPE } from '../../scene/lights/skyGradient.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { singleStep } from './effect.ts';
import type { EffectContext } from './effectContext.ts';

/** `skyBackground` of src/reference/post/effects/. */
export const skyBackground = singleStep((frame) => {
  const [brightness, curve, fade, opacity] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const sky = backdrop(frame, curve).toVar();
  const behind = exp(length(frame.event(frame.pixel)).div(fade).negate()).oneMinus();
  const faded = select(fade.greaterThan(0), behind, 0);
  const covered = frame.hasSurface(frame.pixel);
  const light = select(covered, frame.fogColor(sky, sky), sky).mul(brightness);
  const amount = select(covered, faded, float(1)).mul(opacity);
  return vec4(mix(here.rgb, light, amount), here.w);
});

/** `backdrop` of src/reference/post/effects/skyBackground.ts, at this pixel. */
export function backdrop(frame: EffectContext, curve: Float): Vec3 {
  const { dim, haze, seam } = SKY_SHAPE;
  const { zenith: up, skyZenith: zenith, skyHorizon: horizon, skyGround: ground } = frame.uniforms;
  const height = dot(frame.direction(), up).toVar();
  const above = mix(horizon, zenith, pow(clamp(height, 0, 1), curve));
  const below = mix(horizon.mul(dim), ground, smoothstep(0, haze, height.negate()));
  return mix(below, above, smoothstep(-seam, seam, height));
}
