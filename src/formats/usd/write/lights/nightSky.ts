import { conjugate, multiply } from '../../../../math/quat.ts';
import { EQUATORIAL } from '../../../../scene/stars/equatorial.ts';
import type { NightSky } from '../../../../scene/types.ts';
import { poseLines } from '../motionLines.ts';
import { float } from '../usdaText.ts';
import type { LightWriter } from './lightWriter.ts';

export const writeNightSky: LightWriter<NightSky> = ({ gain, orientation }, placement) => {
  const turn = multiply(orientation, conjugate(EQUATORIAL));
  return {
    type: 'DomeLight',
    properties: [
      'custom token slowlight:sky = "stars"',
      `float inputs:intensity = ${float(gain)}`,
      ...poseLines({ position: [0, 0, 0], orientation: turn }, placement),
    ],
  };
};
