import { abs, exp2, If, vec3, vec4 } from 'three/tsl';
import { dopplerTint } from '../shaders/dopplerTint.ts';
import { glowColor } from '../shaders/glowColor.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { DAYLIGHT } from '../spectrum/lightSpectrum.ts';
import { overlapSum } from './overlapSum.ts';
import { beamed, NO_SHIFT, type Optics, RADIANCE } from './radiance.ts';
import { partsOfSky, skySums } from './skySums.ts';
import type { Uniforms } from './uniforms.ts';

/** Light that meets a shift by D, with its D^power of brightness. */
type Shifted = (rgb: Vec3, D: Float, power: number, uniforms: Uniforms) => Vec3;

/** Light is linear sRGB everywhere, and filters are multiplied channel by channel. `glowing`: something shines by its temperature. */
const inSrgb =
  (shifted: Shifted, glowing: boolean): Optics =>
  (D, uniforms) => {
    const sum = vec3(0).toVar();
    return {
      filter: (rgb) => vec4(rgb, 0),
      send: (light, share, { D: shift }, power) => {
        sum.addAssign(share.xyz.mul(shift ? shifted(light, shift, power, uniforms) : light));
      },
      emit: (light) => {
        sum.addAssign(light);
      },
      glow: ({ luminance, heat }) => {
        if (glowing) sum.addAssign(glowColor(exp2(heat).mul(DAYLIGHT.temperature)).mul(luminance));
      },
      // Of what is invisible at rest it knows nothing.
      radiate: () => {},
      seen: () => shifted(sum, D, RADIANCE, uniforms),
    };
  };

/**
 * Spectra where no light is shifted and all is daylight, or a sky's: bands, what those of coloured lights and surfaces overlap, and what those of surfaces show of the lights of a
 * sky; `dusky`: it may be red.
 */
export const resting =
  (dusky: boolean): Optics =>
  (D, uniforms) => {
    const bands = plain(false)(D, uniforms);
    const overlapping = overlapSum();
    const sky = skySums(dusky);
    return {
      ...bands,
      send: (light, share, passage, power) => {
        const ofSky = passage.source && 'scatters' in passage.source ? partsOfSky(light, dusky) : undefined;
        bands.send(ofSky?.rest ?? light, share, passage, power);
        if (ofSky) sky.send(share, ofSky.luminances);
        if (typeof passage.colored === 'number') overlapping.add(light, share);
      },
      seen: () =>
        bands
          .seen()
          .add(sky.atRest())
          .sub(overlapping.any ? overlapping.atRest() : 0),
    };
  };

/** No light is shifted. */
export const plain = (glowing: boolean): Optics => inSrgb((rgb) => rgb, glowing);

/** The approximate colours: a shift is a tint (spectrum/dopplerTint.ts). Colour and brightness follow D by the settings' shares. */
export const tinted = (glowing: boolean): Optics =>
  inSrgb((rgb, D, power, uniforms) => {
    const light = rgb.toVar();
    const factor = D.toVar();
    If(abs(factor.sub(1)).greaterThan(NO_SHIFT), () => {
      light.assign(dopplerTint(light, factor, uniforms.dopplerMix).mul(beamed(factor, power, uniforms)));
    });
    return light;
  }, glowing);
