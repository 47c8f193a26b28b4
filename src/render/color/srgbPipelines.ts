import { abs, exp2, If, vec3, vec4 } from 'three/tsl';
import { dopplerTint } from '../../shaders/color/dopplerTint.ts';
import { glowColor } from '../../shaders/color/glowColor.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { overlapSum } from './overlapSum.ts';
import { beamingFactor, type ColorPipeline, MIN_SHIFT, RADIANCE_POWER } from './radiance.ts';
import { decomposeSky, skySums } from './skySums.ts';

/** Light that meets a shift by D, with its D^power of brightness. */
type Shifted = (rgb: Vec3, D: Float, power: number, uniforms: FrameUniforms) => Vec3;

/** Light is linear sRGB everywhere, and filters are multiplied channel by channel. `glowing`: something shines by its temperature. */
const srgbPipeline =
  (shifted: Shifted, glowing: boolean): ColorPipeline =>
  (D, uniforms) => {
    const sum = vec3(0).toVar();
    return {
      filter: (rgb) => vec4(rgb, 0),
      addReflected: (light, share, { D: shift }, power) => {
        sum.addAssign(share.xyz.mul(shift ? shifted(light, shift, power, uniforms) : light));
      },
      addEmitted: (light) => {
        sum.addAssign(light);
      },
      addGlow: ({ luminance, log2Temperature }) => {
        if (glowing) sum.addAssign(glowColor(exp2(log2Temperature).mul(DAYLIGHT.temperature)).mul(luminance));
      },
      // Of what is invisible at rest it knows nothing.
      addBlackbody: () => {},
      total: () => shifted(sum, D, RADIANCE_POWER, uniforms),
    };
  };

/**
 * Spectra where no light is shifted and all is daylight, or a sky's: bands, what those of coloured lights and surfaces overlap, and what those of surfaces show of the lights of a
 * sky; `dusky`: it may be red.
 */
export const restPipeline =
  (reddenedSky: boolean): ColorPipeline =>
  (D, uniforms) => {
    const bands = unshiftedPipeline(false)(D, uniforms);
    const overlapping = overlapSum();
    const sky = skySums(reddenedSky);
    return {
      ...bands,
      addReflected: (light, share, passage, power) => {
        const ofSky = passage.source && 'scatters' in passage.source ? decomposeSky(light, reddenedSky) : undefined;
        bands.addReflected(ofSky?.rest ?? light, share, passage, power);
        if (ofSky) sky.addReflected(share, ofSky.luminances);
        if (typeof passage.colored === 'number') overlapping.add(light, share);
      },
      total: () =>
        bands
          .total()
          .add(sky.atRest())
          .sub(overlapping.any ? overlapping.atRest() : 0),
    };
  };

/** No light is shifted. */
export const unshiftedPipeline = (glowing: boolean): ColorPipeline => srgbPipeline((rgb) => rgb, glowing);

/** The approximate colours: a shift is a tint (spectrum/doppler/dopplerTint.ts). Colour and brightness follow D by the settings' shares. */
export const tintPipeline = (glowing: boolean): ColorPipeline =>
  srgbPipeline((rgb, D, power, uniforms) => {
    const light = rgb.toVar();
    const factor = D.toVar();
    If(abs(factor.sub(1)).greaterThan(MIN_SHIFT), () => {
      light.assign(dopplerTint(light, factor, uniforms.dopplerMix).mul(beamingFactor(factor, power, uniforms)));
    });
    return light;
  }, glowing);
