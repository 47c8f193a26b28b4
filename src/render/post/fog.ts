import { exp, float, length, mix, select, vec3, vec4 } from 'three/tsl';
import { FOG } from '../../scene/frameGraph/effects.ts';
import { SKY_SHAPE } from '../../scene/lights/skyGradient.ts';
import { singleStep } from './effect.ts';
import { backdrop } from './skyBackground.ts';

/** `fog` of src/reference/post/effects/; docs/physics.md §8.4. */
export const fog = singleStep((frame) => {
  const [path, brightness, haze, overSky] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const usual = mix(vec3(...FOG.gray), vec3(...FOG.haze), haze);
  const light = frame.fogColor(usual, backdrop(frame, float(SKY_SHAPE.curve))).mul(brightness);
  const transmittance = exp(length(frame.event(frame.pixel)).div(path).negate());
  const coverage = select(frame.hasSurface(frame.pixel), transmittance.oneMinus(), overSky);
  return vec4(mix(here.rgb, light, coverage), here.w);
});
