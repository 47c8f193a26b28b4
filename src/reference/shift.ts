import { scale, type Vec3 } from '../math/vec3.ts';
import type { RenderSettings } from '../scene/view.ts';
import { dopplerTint } from '../spectrum/dopplerTint.ts';

/** The share of a Doppler shift that reaches colour and brightness. */
export type Shares = Pick<RenderSettings, 'dopplerMix' | 'beaming'>;

/** Light that meets a shift by D: colour shifted, and D^power in brightness, each by the settings' share. */
function shifted(rgb: Vec3, D: number, power: number, { dopplerMix, beaming }: Shares): Vec3 {
  return D === 1 ? rgb : scale(dopplerTint(rgb, D, dopplerMix), D ** (power * beaming));
}

/** Radiance that was emitted with `rgb`, as it arrives: L′ = D⁴ L. */
export const seen = (rgb: Vec3, D: number, shares: Shares): Vec3 => shifted(rgb, D, 4, shares);

/** Radiance per solid angle of the emitter's own frame, L′ dΩ′ = D² L dΩ: so an irradiance E′ = D² E of light from one direction. */
export const met = (rgb: Vec3, D: number, shares: Shares): Vec3 => shifted(rgb, D, 2, shares);
