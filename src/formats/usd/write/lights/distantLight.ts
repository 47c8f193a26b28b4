import { degrees } from '../../../../math/angle.ts';
import { shortestRotation } from '../../../../math/quat.ts';
import type { DistantLight, Pose } from '../../../../scene/types.ts';
import { attribute } from '../../layer/specs.ts';
import { float } from '../../layer/values.ts';
import { poseProperties } from '../motions.ts';
import { colorProperties, type LightWriter } from './lightWriter.ts';

export const writeDistantLight: LightWriter<DistantLight> = (light, placement, files) => {
  const pose: Pose = { position: [0, 0, 0], orientation: shortestRotation([0, 0, -1], light.direction) };
  const angle = light.angle === undefined ? [] : [attribute('float', 'inputs:angle', float(degrees(light.angle)))];
  const properties = [...colorProperties(light, files), ...angle, ...poseProperties(pose, placement)];
  return { type: 'DistantLight', properties };
};
