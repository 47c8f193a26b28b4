import { cos, cross, dot, float, max, min, radians, select, sin, vec3, vec4 } from 'three/tsl';
import { relativeLuminance } from '../color/luminance.ts';
import { singleStep } from './effect.ts';

/** `hueShift` of src/reference/post/effects/. */
export const hueShift = singleStep((frame) => {
  const [degrees, saturation] = frame.args;
  const here = frame.image.at(frame.pixel).toVar();
  const angle = radians(degrees);
  const axis = vec3(1 / Math.sqrt(3));
  const along = axis.mul(dot(axis, here.rgb)).mul(cos(angle).oneMinus());
  const turned = here.rgb
    .mul(cos(angle))
    .add(cross(axis, here.rgb).mul(sin(angle)))
    .add(along)
    .toVar();
  const light = relativeLuminance(here.rgb).toVar();
  const chroma = turned.sub(relativeLuminance(turned)).mul(saturation).toVar();
  const least = min(chroma.x, min(chroma.y, chroma.z)).toVar();
  const share = select(light.add(least).lessThan(0), max(light, 0).div(least.negate()), float(1));
  return vec4(vec3(light).add(chroma.mul(share)), here.w);
});
