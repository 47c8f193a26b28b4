import { abs, If, vec3, vec4 } from 'three/tsl';
import { dopplerTint } from '../shaders/dopplerTint.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { beamed, NO_SHIFT, type Optics, RADIANCE } from './radiance.ts';
import type { Uniforms } from './uniforms.ts';

/** The approximate colours: light is linear sRGB everywhere, filters are multiplied channel by channel, and a shift is a tint (spectrum/dopplerTint.ts). */
export const tinted: Optics = (D, uniforms) => {
  const sum = vec3(0).toVar();
  return {
    filter: (rgb) => vec4(rgb, 0),
    send: (light, share, { D: shift }, power) => {
      sum.addAssign(share.xyz.mul(shift ? shifted(light, shift, power, uniforms) : light));
    },
    emit: (light) => {
      sum.addAssign(light);
    },
    glow: ({ luminance }) => {
      sum.addAssign(luminance);
    },
    seen: () => shifted(sum, D, RADIANCE, uniforms),
  };
};

/** Light `rgb` that meets a shift by D: colour shifted, and D^power in brightness, each by the settings' share. */
function shifted(rgb: Vec3, D: Float, power: number, uniforms: Uniforms): Vec3 {
  const light = rgb.toVar();
  const factor = D.toVar();
  If(abs(factor.sub(1)).greaterThan(NO_SHIFT), () => {
    light.assign(dopplerTint(light, factor, uniforms.dopplerMix).mul(beamed(factor, power, uniforms)));
  });
  return light;
}
