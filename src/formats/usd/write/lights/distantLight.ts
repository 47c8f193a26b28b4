import { degrees } from '../../../../math/angle.ts';
import { shortestRotation } from '../../../../math/quat.ts';
import type { DistantLight, Pose } from '../../../../scene/types.ts';
import { poseLines } from '../motionLines.ts';
import { float } from '../usdaText.ts';
import { colorLines, type LightWriter } from './lightWriter.ts';

export const writeDistantLight: LightWriter<DistantLight> = (light, placement, files) => {
  const pose: Pose = { position: [0, 0, 0], orientation: shortestRotation([0, 0, -1], light.direction) };
  const angle = light.angle === undefined ? [] : [`float inputs:angle = ${float(degrees(light.angle))}`];
  const properties = [...colorLines(light, files), ...angle, ...poseLines(pose, placement)];
  return { type: 'DistantLight', properties };
};
