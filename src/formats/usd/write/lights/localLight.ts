import { degrees } from '../../../../math/angle.ts';
import type { LightShaping, LocalLight } from '../../../../scene/types.ts';
import { attribute, type Properties, schemas } from '../../layer/specs.ts';
import { float } from '../../layer/values.ts';
import { lifeProperties } from '../lives.ts';
import { slowlightMotion, transformOf } from '../motions.ts';
import { colorProperties, type LightWriter } from './lightWriter.ts';

/** `sizes` [m], by the names of their inputs in the order of the alphabet. */
export const localLightWriter =
  <L extends LocalLight>(type: string, sizes: (light: L) => Readonly<Record<string, number>>): LightWriter<L> =>
  (light, placement, files) => {
    const shaping = light.shaping ? shapingProperties(light.shaping) : [];
    return {
      type,
      ...(light.shaping && { metadata: schemas('ShapingAPI') }),
      properties: [
        ...colorProperties(light, files),
        ...Object.entries(sizes(light)).map(([name, size]) =>
          attribute('float', `inputs:${name}`, float(size / placement.metersPerUnit)),
        ),
        ...shaping,
        ...slowlightMotion(light.motion, placement),
        ...lifeProperties(placement),
        ...transformOf(light.motion, placement),
      ],
    };
  };

/** In degrees from the axis; a cone of 180° is all directions. */
function shapingProperties({ inner, outer, focus }: LightShaping): Properties {
  const open = outer > Math.PI;
  return [
    attribute('float', 'inputs:shaping:cone:angle', float(open ? 180 : degrees(outer))),
    attribute('float', 'inputs:shaping:cone:softness', float(open ? 0 : 1 - inner / outer)),
    attribute('float', 'inputs:shaping:focus', float(focus)),
  ];
}
