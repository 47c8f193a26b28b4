import { multiply } from '../../math/quat.ts';
import { scale } from '../../math/vec3.ts';
import { luminanceOf } from '../../scene/gauge.ts';
import { EQUATORIAL } from '../../scene/stars/equatorial.ts';
import { defineNode } from '../define.ts';
import { rotation, vector } from '../geometry/shared.ts';
import { brightness, lightColor, lightOf, madeOf, nameParam } from './shine.ts';

const STARS = { param: 'sky', is: 'stars' } as const;

/** What is seen behind all things: an even sky, or the fixed stars. */
export const skyNode = defineNode({
  id: 'sky',
  title: 'node.sky',
  help: 'node.sky.help',
  category: 'composition',
  params: {
    name: nameParam('Sky'),
    sky: {
      kind: 'choice',
      title: 'param.sky',
      default: 'even',
      options: [
        { value: 'even', title: 'sky.even' },
        { value: 'stars', title: 'sky.stars' },
      ],
    },
    color: lightColor,
    brightness: brightness('param.skyBrightness', 1),
    madeOf,
    rotation: { ...vector('param.rotation', [0, 0, 0], '°'), onlyWhen: STARS },
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  async evaluate({ spectrum }, { name, sky, color, brightness: strength, madeOf: preset, rotation: angles }, { node }) {
    const light = lightOf(name, node, preset, spectrum);
    if (sky === 'even') return { lights: [{ kind: 'dome', ...light, color: scale(color, strength) }] };
    // Loaded with the first sky that has stars: the page is light without them.
    const { brightStars } = await import('../../scene/stars/brightStars.ts');
    const orientation = multiply(rotation(angles), EQUATORIAL);
    const gain = luminanceOf(...scale(color, strength));
    return { lights: [{ kind: 'stars', path: light.path, stars: brightStars(), orientation, gain }] };
  },
});
