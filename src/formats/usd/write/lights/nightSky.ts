import { conjugate, multiply } from '../../../../math/quat.ts';
import { EQUATORIAL } from '../../../../scene/stars/equatorial.ts';
import type { NightSky } from '../../../../scene/types.ts';
import { attribute, custom } from '../../layer/specs.ts';
import { float, token } from '../../layer/values.ts';
import { poseProperties } from '../motions.ts';
import type { LightWriter } from './lightWriter.ts';

export const writeNightSky: LightWriter<NightSky> = ({ gain, orientation }, placement) => {
  const turn = multiply(orientation, conjugate(EQUATORIAL));
  return {
    type: 'DomeLight',
    properties: [
      custom('token', 'slowlight:sky', token('stars')),
      attribute('float', 'inputs:intensity', float(gain)),
      ...poseProperties({ position: [0, 0, 0], orientation: turn }, placement),
    ],
  };
};
