import * as mat4 from '../../../../../math/mat4.ts';
import { multiply } from '../../../../../math/quat.ts';
import { EQUATORIAL } from '../../../../../scene/stars/equatorial.ts';
import type { NightSky } from '../../../../../scene/types.ts';
import { relativeLuminance } from '../../../../../scene/view/metering.ts';
import { textAt } from '../../../layer/attributes.ts';
import { emissionOf } from '../lightInputs.ts';
import { DOME_LIGHT } from './domeLight.ts';
import type { LightSchema } from './lightSchema.ts';

/** A dome that our own attribute says to be the bright stars, as its frame turns them; their colours are their own. */
export const NIGHT_SKY: LightSchema<NightSky> = {
  typeNames: DOME_LIGHT.typeNames,
  isAsked: (prim) => textAt(prim, 'slowlight:sky', undefined) === 'stars',
  moves: false,
  async read({ context, prim, frame }) {
    // Loaded with the first scene that has stars: the page is light without them.
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
