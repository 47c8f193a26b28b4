import { abs, exp2, If, vec3, vec4 } from 'three/tsl';
import { dopplerTint } from '../../shaders/color/dopplerTint.ts';
import { glowColor } from '../../shaders/color/glowColor.ts';
import { linearSpectrumShift, twoWavelengthShift } from '../../shaders/color/historicalShifts.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { MIN_SHIFT, type RgbColorMode, SHIFTS_EACH_LIGHT } from '../../spectrum/doppler/rgbShifts.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { overlapSum } from './overlapSum.ts';
import { beamingFactor, type ColorPipeline, RADIANCE_POWER } from './radiance.ts';
import { decomposeSky, skySums } from './skySums.ts';

/** Shifts light by D, with D^power of brightness. */
type Shifted = (rgb: Vec3, D: Float, power: number, uniforms: FrameUniforms) => Vec3;

/**
 * Light is linear sRGB throughout, and filters multiply channel by channel. `glowing`: some surface glows by its temperature; `eachLight`: what is seen of
 * every light is shifted by itself, not their sum.
 */
const srgbPipeline =
  (applyShift: Shifted, glowing: boolean, eachLight = false): ColorPipeline =>
  (D, uniforms) => {
    const sum = vec3(0).toVar();
    const seen = (light: Vec3): Vec3 => applyShift(light, D, RADIANCE_POWER, uniforms);
    const add = (light: Vec3): void => {
      sum.addAssign(eachLight ? seen(light) : light);
    };
    return {
      filter: (rgb) => vec4(rgb, 0),
      addReflected: (light, reflectance, { D: shift }, power) => {
        add(reflectance.xyz.mul(shift ? applyShift(light, shift, power, uniforms) : light));
      },
      addEmitted: add,
      addGlow: ({ luminance, log2Temperature }) => {
        if (glowing) add(glowColor(exp2(log2Temperature).mul(DAYLIGHT.temperature)).mul(luminance));
      },
      // Sources that are invisible at rest are not modelled.
      addBlackbody: () => {},
      total: () => (eachLight ? sum : seen(sum)),
    };
  };

/**
 * Spectra if no light is shifted and all is daylight or a sky's: bands, the overlaps of coloured lights and surfaces, and the colours of a sky's lights
 * through the bands of surfaces; `reddenedSky`: the sky may be red.
 */
export const restPipeline =
  (reddenedSky: boolean): ColorPipeline =>
  (D, uniforms) => {
    const bands = unshiftedPipeline(false)(D, uniforms);
    const overlapping = overlapSum();
    const sky = skySums(reddenedSky);
    return {
      ...bands,
      addReflected: (light, reflectance, incident, power) => {
        const ofSky = incident.source && 'scatters' in incident.source ? decomposeSky(light, reddenedSky) : undefined;
        bands.addReflected(ofSky?.rest ?? light, reflectance, incident, power);
        if (ofSky) sky.addReflected(reflectance, ofSky.luminances);
        if (typeof incident.colored === 'number') overlapping.add(light, reflectance);
      },
      total: () =>
        bands
          .total()
          .add(sky.atRest())
          .sub(overlapping.any ? overlapping.atRest() : 0),
    };
  };

/** For variants without any shift. */
export const unshiftedPipeline = (glowing: boolean): ColorPipeline => srgbPipeline((rgb) => rgb, glowing);

const SHIFTS: Readonly<Record<RgbColorMode, (rgb: Vec3, D: Float, amount: Float) => Vec3>> = {
  approximate: dopplerTint,
  'two-wavelengths': twoWavelengthShift,
  'linear-spectrum': linearSpectrumShift,
};

/** Colours without spectra (spectrum/doppler/rgbShifts.ts). Colour and brightness follow D by the fractions in the settings. */
export const rgbShiftPipeline = (mode: RgbColorMode, glowing: boolean): ColorPipeline =>
  srgbPipeline(
    (rgb, D, power, uniforms) => {
      const light = rgb.toVar();
      const factor = D.toVar();
      If(abs(factor.sub(1)).greaterThan(MIN_SHIFT), () => {
        light.assign(SHIFTS[mode](light, factor, uniforms.dopplerMix).mul(beamingFactor(factor, power, uniforms)));
      });
      return light;
    },
    glowing,
    SHIFTS_EACH_LIGHT.includes(mode),
  );
