import { float } from 'three/tsl';
import { COSMIC_TEMPERATURE, DAYLIGHT_LUMINANCE } from '../../../scene/stars/cosmicBackground.ts';
import type { NightSky } from '../../../scene/types.ts';
import type { RadianceAccumulator } from '../../color/radiance.ts';

/** Adds the cosmic background, which is between the stars; these are drawn as points (shading/starPoints.ts). */
export const addCosmicBackground = ({ gain }: NightSky, accumulator: RadianceAccumulator): void =>
  accumulator.addBlackbody(COSMIC_TEMPERATURE, float(gain * DAYLIGHT_LUMINANCE));
