import { msg } from '../../messages/message.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import { defineNode } from '../defineNode.ts';
import { emissionParam } from './lightParams.ts';

/** An emission spectrum: of a lamp or a blackbody. */
export const spectrumNode = defineNode({
  id: 'spectrum',
  title: msg`Spectrum`,
  help: msg`The spectrum of a light.`,
  category: 'utility',
  params: {
    kind: {
      kind: 'choice',
      title: msg`Kind`,
      default: 'thermal',
      options: [
        { value: 'thermal', title: msg`Blackbody` },
        { value: 'lamp', title: msg`Lamp` },
      ],
    },
    temperature: {
      kind: 'number',
      title: msg`Temperature`,
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
