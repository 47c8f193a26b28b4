import { IDENTITY } from '../../../../math/quat.ts';
import type { DomeLight } from '../../../../scene/types.ts';
import { SKY_ATTRIBUTES } from '../../../attributes/hints.ts';
import { poseLines, type WriteContext } from '../motionLines.ts';
import { floats, type Lines } from '../usdaText.ts';
import { colorLines, type LightWriter } from './lightWriter.ts';

export const writeDomeLight: LightWriter<DomeLight> = (light, placement, files) => {
  const { gradient } = light;
  const sky = gradient
    ? [gradient.horizon, gradient.ground].map((part, k) => `custom color3f ${SKY_ATTRIBUTES[k]} = ${floats(part)}`)
    : [];
  const picture = files.picture ? pictureLines(light, files.picture, placement) : [];
  return { type: 'DomeLight', properties: [...colorLines(light, files), ...sky, ...picture] };
};

const pictureLines = ({ orientation = IDENTITY }: DomeLight, file: string, placement: WriteContext): Lines => [
  `asset inputs:texture:file = @${file}@`,
  'token inputs:texture:format = "latlong"',
  ...poseLines({ position: [0, 0, 0], orientation }, placement),
];
