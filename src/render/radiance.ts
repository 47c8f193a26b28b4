import { exp2, log2, max } from 'three/tsl';
import { dopplerTint } from '../shaders/dopplerTint.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import type { Uniforms } from './uniforms.ts';

/** D^(power · beaming): the share of the beaming that the settings ask for. */
export const beamed = (D: Float, power: number, { beaming }: Uniforms): Float =>
  exp2(log2(max(D, 1e-20)).mul(beaming.mul(power)));

/** Radiance that was emitted with `rgb`, as it arrives: colour shifted, brightness times D⁴, each by the settings' share. */
export const seen = (rgb: Vec3, D: Float, uniforms: Uniforms): Vec3 =>
  dopplerTint(rgb, D, uniforms.dopplerMix).mul(beamed(D, 4, uniforms));
