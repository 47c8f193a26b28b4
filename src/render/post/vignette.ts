import { abs, dot, mix, pow, radians, select, tan, vec4 } from 'three/tsl';
import { singleStep } from './effect.ts';

/** `vignette` of reference/effects/. */
export const vignette = singleStep((frame) => {
  const [strength, power, corner] = frame.args;
  const { halfTangents, frustumCenter } = frame.uniforms;
  const farthest = abs(frustumCenter).add(halfTangents).toVar();
  const here = frame.image.at(frame.pixel).toVar();
  const wanted = tan(radians(corner)).toVar();
  const stretch = select(corner.greaterThan(0), wanted.mul(wanted).div(dot(farthest, farthest)), 1);
  const off = frame.tangents(frame.pixel).toVar();
  const kept = pow(dot(off, off).mul(stretch).add(1), power.div(-2));
  return vec4(here.rgb.mul(mix(1, kept, strength)), here.w);
});
