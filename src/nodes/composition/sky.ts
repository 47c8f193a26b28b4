import { multiply } from '../../math/quat.ts';
import { scale, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { backdropColors } from '../../scene/lights/sceneLights.ts';
import { EQUATORIAL } from '../../scene/stars/equatorial.ts';
import { relativeLuminance } from '../../scene/view/metering.ts';
import { rotationXYZ, vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { brightnessParam, emissionParam, lightBase, lightColorParam, nameParam } from './lightParams.ts';

const STARS = { param: 'sky', is: 'stars' } as const;
const GRADIENT = { param: 'sky', is: 'gradient' } as const;
const { zenith: ZENITH, horizon: HORIZON, ground: GROUND } = backdropColors({ lights: [] });

/** Background of the scene: a uniform sky, a gradient, or the stars. */
export const skyNode = defineNode({
  id: 'sky',
  title: msg`Sky`,
  help: msg`The background of the scene: a uniform sky, a gradient from the horizon to the zenith and to the ground, or the stars. Post process with Sky background lets distant things fade into it.`,
  category: 'composition',
  params: {
    name: nameParam('Sky'),
    sky: {
      kind: 'choice',
      title: msg`Sky`,
      default: 'even',
      options: [
        { value: 'even', title: msg`Even` },
        { value: 'gradient', title: msg`Gradient` },
        { value: 'stars', title: msg`Stars` },
      ],
    },
    color: lightColorParam,
    zenith: { kind: 'color', title: msg`Zenith`, default: ZENITH, onlyWhen: GRADIENT },
    horizon: { kind: 'color', title: msg`Horizon`, default: HORIZON, onlyWhen: GRADIENT },
    ground: { kind: 'color', title: msg`Ground`, default: GROUND, onlyWhen: GRADIENT },
    brightness: brightnessParam(msg`Brightness`, 1),
    madeOf: emissionParam,
    rotation: { ...vectorParam(msg`Rotation`, [0, 0, 0], '°'), onlyWhen: STARS },
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  async evaluate(
    { spectrum },
    { name, sky, color, brightness: strength, madeOf: preset, rotation: angles, ...colors },
    { node },
  ) {
    const light = lightBase(name, node, preset, spectrum);
    const gain = scale(color, strength);
    if (sky === 'even') return { lights: [{ kind: 'dome', ...light, color: gain }] };
    if (sky === 'gradient') {
      const lit = (own: Vec3): Vec3 => [own[0] * gain[0], own[1] * gain[1], own[2] * gain[2]];
      const gradient = { horizon: lit(colors.horizon), ground: lit(colors.ground) };
      return { lights: [{ kind: 'dome', ...light, color: lit(colors.zenith), gradient }] };
    }
    // Loaded with the first starry sky, to keep the page small.
    const { brightStars } = await import('../../scene/stars/brightStars.ts');
    const orientation = multiply(rotationXYZ(angles), EQUATORIAL);
    const stars = brightStars();
    return { lights: [{ kind: 'stars', path: light.path, stars, orientation, gain: relativeLuminance(...gain) }] };
  },
});
