import { normalize, scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { vectorParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { brightnessParam, emissionParam, lightBase, lightColorParam, nameParam } from './lightParams.ts';

/** A distant light. */
export const sunNode = defineNode({
  id: 'sun',
  title: msg`Sun`,
  help: msg`A distant light with a single direction.`,
  category: 'composition',
  params: {
    name: nameParam('Sun'),
    direction: vectorParam(msg`Shines towards`, [-0.5, -1, -0.7]),
    color: lightColorParam,
    brightness: brightnessParam(msg`Irradiance`, 2.5),
    madeOf: emissionParam,
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  evaluate({ spectrum }, { name, direction, color, brightness: strength, madeOf: preset }, { node }) {
    const light = lightBase(name, node, preset, spectrum);
    const sun = { ...light, direction: normalize(direction, [0, -1, 0]), color: scale(color, strength) };
    return { lights: [{ kind: 'distant', ...sun }] };
  },
});
