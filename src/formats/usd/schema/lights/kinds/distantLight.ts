import { radians } from '../../../../../math/angle.ts';
import * as mat4 from '../../../../../math/mat4.ts';
import { normalize } from '../../../../../math/vec3.ts';
import type { DistantLight } from '../../../../../scene/types.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { StageContext } from '../../context.ts';
import { emissionOf, lightNumber, spectrumOf } from '../lightInputs.ts';
import type { LightSchema } from './lightSchema.ts';

export const DISTANT_LIGHT: LightSchema<DistantLight> = {
  typeNames: ['DistantLight'],
  moves: false,
  async read({ context, prim, frame }) {
    const direction = normalize(mat4.transformVector(frame.matrixAt(context.startCode), [0, 0, -1]), [0, 0, -1]);
    const color = emissionOf(context, prim, DISTANT_INTENSITY);
    const light = { kind: 'distant', path: prim.path, direction, color, ...angleOf(context, prim) } as const;
    return { ...light, ...(await spectrumOf(context, prim)) };
  },
};

/** Angular diameter [rad] of a distant light, authored in degrees; undefined if absent. */
function angleOf(context: StageContext, prim: PrimSpec): Pick<DistantLight, 'angle'> {
  const angle = lightNumber(context, prim, 'angle');
  return angle === undefined ? {} : { angle: radians(Math.min(Math.max(angle, 0), 180)) };
}

/**
 * Default irradiance. UsdLux's fallback intensity of a distant light is 50000 over a disc of 0.53°, an irradiance of
 * 50000 π sin²(0.265°). Authored intensities are taken as the irradiance, independent of the angle.
 */
const DISTANT_INTENSITY = 50000 * Math.PI * Math.sin(radians(0.265)) ** 2;
