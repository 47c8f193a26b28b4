import { abs, dot, mix, pow, radians, select, tan, vec4 } from 'three/tsl';
import { singleStep } from './effect.ts';

/** `vignette` of reference/post/effects/vignette.ts. */
export const vignette = singleStep((frame) => {
  const [strength, power, corner] = frame.args;
  const { halfTangents, frustumCenter } = frame.uniforms;
  const farthest = abs(frustumCenter).add(halfTangents).toVar();
  const here = frame.image.at(frame.pixel).toVar();
  const cornerTangent = tan(radians(corner)).toVar();
  const stretch = select(corner.greaterThan(0), cornerTangent.mul(cornerTangent).div(dot(farthest, farthest)), 1);
  const tangents = frame.tangents(frame.pixel).toVar();
  const transmission = pow(dot(tangents, tangents).mul(stretch).add(1), power.div(-2));
  return vec4(here.rgb.mul(mix(1, transmission, strength)), here.w);
});
