import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import { defineNode } from '../defineNode.ts';
import { emissionParam } from './lightParams.ts';

/** An emission spectrum: of a lamp or a blackbody. */
export const spectrumNode = defineNode({
  id: 'spectrum',
  title: 'node.spectrum',
  help: 'node.spectrum.help',
  category: 'utility',
  params: {
    kind: {
      kind: 'choice',
      title: 'param.spectrumKind',
      default: 'thermal',
      options: [
        { value: 'thermal', title: 'spectrum.thermal' },
        { value: 'lamp', title: 'spectrum.lamp' },
      ],
    },
    temperature: {
      kind: 'number',
      title: 'param.temperature',
      unit: 'K',
      default: 6504,
      min: 500,
      max: 100_000,
      step: 1,
      scale: 'log',
      onlyWhen: { param: 'kind', is: 'thermal' },
    },
    lamp: { ...emissionParam, onlyWhen: { param: 'kind', is: 'lamp' } },
  },
  inputs: {},
  outputs: { spectrum: { type: 'spectrum' } },
  evaluate(_inputs, { kind, temperature, lamp }) {
    if (kind === 'lamp') return { spectrum: LIGHT_PRESETS.get(lamp)!.spectrum };
    return { spectrum: { kind: 'thermal', temperature } };
  },
});
