import { exp, length, mix, select, vec3, vec4 } from 'three/tsl';
import { FOG } from '../../scene/frameGraph/effects.ts';
import { singleStep } from './effect.ts';

/** `fog` of src/reference/post/effects/; docs/physics.md §8.4. */
export const fog = singleStep((frame) => {
  const [path, brightness, haze, overSky] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const light = mix(vec3(...FOG.gray), vec3(...FOG.haze), haze).mul(brightness);
  const transmittance = exp(length(frame.event(frame.pixel)).div(path).negate());
  const coverage = select(frame.hasSurface(frame.pixel), transmittance.oneMinus(), overSky);
  return vec4(mix(here.rgb, light, coverage), here.w);
});
