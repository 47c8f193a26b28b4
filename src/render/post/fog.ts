import { exp, length, mix, select, vec3, vec4 } from 'three/tsl';
import { FOG } from '../../scene/frameGraph/effects.ts';
import { singleStep } from './effect.ts';

/** `fog` of reference/effects/. */
export const fog = singleStep((frame) => {
  const [path, brightness, haze, overSky] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const light = mix(vec3(...FOG.gray), vec3(...FOG.haze), haze).mul(brightness);
  const passed = exp(length(frame.event(frame.pixel)).div(path).negate());
  const covered = select(frame.hasSurface(frame.pixel), passed.oneMinus(), overSky);
  return vec4(mix(here.rgb, light, covered), here.w);
});
