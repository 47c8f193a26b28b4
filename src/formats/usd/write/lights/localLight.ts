import { degrees } from '../../../../math/angle.ts';
import type { LightShaping, LocalLight } from '../../../../scene/types.ts';
import { motionLines } from '../motionLines.ts';
import { slowlightLines } from '../prims.ts';
import { float, type Lines } from '../usdaText.ts';
import { colorLines, type LightWriter } from './lightWriter.ts';

/** `sizes` [m], by the names of their inputs in the order of the alphabet. */
export const localLightWriter =
  <L extends LocalLight>(type: string, sizes: (light: L) => Readonly<Record<string, number>>): LightWriter<L> =>
  (light, placement, files) => {
    const shaping = light.shaping ? shapingLines(light.shaping) : [];
    return {
      type,
      ...(light.shaping && { metadata: ['prepend apiSchemas = ["ShapingAPI"]'] }),
      properties: [
        ...colorLines(light, files),
        ...Object.entries(sizes(light)).map(
          ([name, size]) => `float inputs:${name} = ${float(size / placement.metersPerUnit)}`,
        ),
        ...shaping,
        ...slowlightLines(light, placement),
        ...motionLines(light.motion, placement),
      ],
    };
  };

/** In degrees from the axis; a cone of 180° is all directions. */
function shapingLines({ inner, outer, focus }: LightShaping): Lines {
  const open = outer > Math.PI;
  return [
    `float inputs:shaping:cone:angle = ${float(open ? 180 : degrees(outer))}`,
    `float inputs:shaping:cone:softness = ${float(open ? 0 : 1 - inner / outer)}`,
    `float inputs:shaping:focus = ${float(focus)}`,
  ];
}
