import { normalize, scale } from '../../math/vec3.ts';
import { defineNode } from '../define.ts';
import { vector } from '../geometry/shared.ts';
import { brightness, lightColor, lightOf, madeOf, nameParam } from './shine.ts';

/** Light from far away, all from one side. */
export const sunNode = defineNode({
  id: 'sun',
  title: 'node.sun',
  help: 'node.sun.help',
  category: 'composition',
  params: {
    name: nameParam('Sun'),
    direction: vector('param.lightDirection', [-0.5, -1, -0.7]),
    color: lightColor,
    brightness: brightness('param.irradiance', 2.5),
    madeOf,
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  evaluate({ spectrum }, { name, direction, color, brightness: strength, madeOf: preset }, { node }) {
    const light = lightOf(name, node, preset, spectrum);
    const sun = { ...light, direction: normalize(direction, [0, -1, 0]), color: scale(color, strength) };
    return { lights: [{ kind: 'distant', ...sun }] };
  },
});
