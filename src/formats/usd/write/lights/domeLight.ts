import { IDENTITY } from '../../../../math/quat.ts';
import type { DomeLight } from '../../../../scene/types.ts';
import { SKY_ATTRIBUTES } from '../../../attributes/hints.ts';
import { attribute, custom, type Properties } from '../../layer/specs.ts';
import { asset, token, tuple } from '../../layer/values.ts';
import { poseProperties, type WriteContext } from '../motions.ts';
import { colorProperties, type LightWriter } from './lightWriter.ts';

export const writeDomeLight: LightWriter<DomeLight> = (light, placement, files) => {
  const { gradient } = light;
  const sky = gradient
    ? [gradient.horizon, gradient.ground].map((part, k) => custom('color3f', SKY_ATTRIBUTES[k], tuple('float3', part)))
    : [];
  const picture = files.picture ? pictureProperties(light, files.picture, placement) : [];
  return { type: 'DomeLight', properties: [...colorProperties(light, files), ...sky, ...picture] };
};

const pictureProperties = (
  { orientation = IDENTITY }: DomeLight,
  file: string,
  placement: WriteContext,
): Properties => [
  attribute('asset', 'inputs:texture:file', asset(file)),
  attribute('token', 'inputs:texture:format', token('latlong')),
  ...poseProperties({ position: [0, 0, 0], orientation }, placement),
];
