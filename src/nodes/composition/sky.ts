import { multiply } from '../../math/quat.ts';
import { scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { EQUATORIAL } from '../../scene/stars/equatorial.ts';
import { relativeLuminance } from '../../scene/view/metering.ts';
import { rotationXYZ, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { brightnessParam, emissionParam, lightBase, lightColorParam, nameParam } from './lightParams.ts';

const STARS = { param: 'sky', is: 'stars' } as const;

/** Background of the scene: a uniform sky, or the stars. */
export const skyNode = defineNode({
  id: 'sky',
  title: msg`Sky`,
  help: msg`The background of the scene: a uniform sky, or the stars.`,
  category: 'composition',
  params: {
    name: nameParam('Sky'),
    sky: {
      kind: 'choice',
      title: msg`Sky`,
      default: 'even',
      options: [
        { value: 'even', title: msg`Even` },
        { value: 'stars', title: msg`Stars` },
      ],
    },
    color: lightColorParam,
    brightness: brightnessParam(msg`Brightness`, 1),
    madeOf: emissionParam,
    rotation: { ...vectorParam(msg`Rotation`, [0, 0, 0], '°'), onlyWhen: STARS },
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  async evaluate({ spectrum }, { name, sky, color, brightness: strength, madeOf: preset, rotation: angles }, { node }) {
    const light = lightBase(name, node, preset, spectrum);
    if (sky === 'even') return { lights: [{ kind: 'dome', ...light, color: scale(color, strength) }] };
    // Loaded with the first starry sky, to keep the page small.
    const { brightStars } = await import('../../scene/stars/brightStars.ts');
    const orientation = multiply(rotationXYZ(angles), EQUATORIAL);
    const gain = relativeLuminance(...scale(color, strength));
    return { lights: [{ kind: 'stars', path: light.path, stars: brightStars(), orientation, gain }] };
  },
});
