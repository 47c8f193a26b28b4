import * as mat4 from '../../../../../math/mat4.ts';
import { multiply } from '../../../../../math/quat.ts';
import { EQUATORIAL } from '../../../../../scene/stars/equatorial.ts';
import type { NightSky } from '../../../../../scene/types.ts';
import { relativeLuminance } from '../../../../../scene/view/metering.ts';
import { textAt } from '../../../layer/attributes.ts';
import { emissionOf } from '../lightInputs.ts';
import { DOME_LIGHT } from './domeLight.ts';
import type { LightSchema } from './lightSchema.ts';

/** A dome with `slowlight:sky = "stars"`: the bright stars, rotated by its frame, with their own colours. */
export const NIGHT_SKY: LightSchema<NightSky> = {
  typeNames: DOME_LIGHT.typeNames,
  isAsked: (prim) => textAt(prim, 'slowlight:sky', undefined) === 'stars',
  moves: false,
  async read({ context, prim, frame }) {
    // The catalogue is imported lazily to keep the page small.
    const { brightStars } = await import('../../../../../scene/stars/brightStars.ts');
    const { orientation } = mat4.decomposeRigid(frame.matrixAt(context.startCode)).pose;
    return {
      kind: 'stars',
      path: prim.path,
      stars: brightStars(),
      orientation: multiply(orientation, EQUATORIAL),
      gain: relativeLuminance(...emissionOf(context, prim)),
    };
  },
};
