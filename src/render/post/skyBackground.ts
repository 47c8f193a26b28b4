import { clamp, dot, exp, float, length, mix, pow, select, smoothstep, vec3, vec4 } from 'three/tsl';
import { DAY_SKY } from '../../scene/lights/sceneLights.ts';
import { SKY_SHAPE } from '../../scene/lights/skyGradient.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { singleStep } from './effect.ts';

/** `skyBackground` of src/reference/post/effects/. */
export const skyBackground = singleStep((frame) => {
  const [brightness, curve, fade, opacity] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const sky = gradientSky(dot(frame.direction(), frame.uniforms.zenith).toVar(), curve).mul(brightness);
  const behind = exp(length(frame.event(frame.pixel)).div(fade).negate()).oneMinus();
  const faded = select(fade.greaterThan(0), behind, 0);
  const amount = select(frame.hasSurface(frame.pixel), faded, float(1)).mul(opacity);
  return vec4(mix(here.rgb, sky, amount), here.w);
});

function gradientSky(height: Float, curve: Float): Vec3 {
  const { dim, haze, seam } = SKY_SHAPE;
  const horizon = vec3(...DAY_SKY.gradient.horizon);
  const above = mix(horizon, vec3(...DAY_SKY.color), pow(clamp(height, 0, 1), curve));
  const below = mix(horizon.mul(dim), vec3(...DAY_SKY.gradient.ground), smoothstep(0, haze, height.negate()));
  return mix(below, above, smoothstep(-seam, seam, height));
}
