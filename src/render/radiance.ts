import { abs, exp2, Fn, If, log2, max } from 'three/tsl';
import { dopplerTint } from '../shaders/dopplerTint.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import type { Uniforms } from './uniforms.ts';

/** Shifts below this change no pixel, and most surfaces rest: the tint is skipped there. */
const NO_SHIFT = 1e-5;

/** D^(power · beaming): the share of the beaming that the settings ask for. */
export const beamed = (D: Float, power: number, { beaming }: Uniforms): Float =>
  exp2(log2(max(D, 1e-20)).mul(beaming.mul(power)));

/** Light `rgb` that meets a shift by D: colour shifted, and D^power in brightness, each by the settings' share. */
const shifted = (rgb: Vec3, D: Float, power: number, uniforms: Uniforms): Vec3 =>
  Fn(() => {
    const light = rgb.toVar();
    const factor = D.toVar();
    If(abs(factor.sub(1)).greaterThan(NO_SHIFT), () => {
      light.assign(dopplerTint(light, factor, uniforms.dopplerMix).mul(beamed(factor, power, uniforms)));
    });
    return light;
  })();

/** Radiance that was emitted with `rgb`, as it arrives: L′ = D⁴ L. */
export const seen = (rgb: Vec3, D: Float, uniforms: Uniforms): Vec3 => shifted(rgb, D, 4, uniforms);

/** Irradiance of a collimated beam, on a surface that moves against it: E′ = D² E. */
export const met = (rgb: Vec3, D: Float, uniforms: Uniforms): Vec3 => shifted(rgb, D, 2, uniforms);
