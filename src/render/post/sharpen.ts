import { max, min, vec2, vec3, vec4 } from 'three/tsl';
import { singleStep } from './effect.ts';

/** `sharpen` of src/reference/post/effects/. */
export const sharpen = singleStep((frame) => {
  const [strength, overshoot] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const blurred = here.rgb.mul(1 / 4).toVar();
  const minColor = here.rgb.toVar();
  const maxColor = here.rgb.toVar();
  for (const i of [-1, 0, 1])
    for (const j of [-1, 0, 1]) {
      if (i === 0 && j === 0) continue;
      const texel = frame.image.at(frame.pixel.add(vec2(i, j))).rgb.toVar();
      blurred.addAssign(texel.mul(i * j === 0 ? 1 / 8 : 1 / 16));
      minColor.assign(min(minColor, texel));
      maxColor.assign(max(maxColor, texel));
    }
  const slack = maxColor.sub(minColor).mul(overshoot).toVar();
  const sharp = here.rgb.add(here.rgb.sub(blurred).mul(strength));
  return vec4(min(max(sharp, max(minColor.sub(slack), vec3(0))), maxColor.add(slack)), here.w);
});
