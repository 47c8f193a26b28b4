import { defineNode } from '../define.ts';
import { rasterizing } from './rasterizing.ts';

/** Draws what the observer sees into a G-buffer. */
export const relativityRasterize = defineNode({
  id: 'relativity-rasterize',
  title: 'node.rasterize',
  help: 'node.rasterize.help',
  category: 'render',
  params: {
    colors: {
      kind: 'choice',
      title: 'param.colors',
      help: 'param.colors.help',
      default: 'spectral',
      options: [
        { value: 'spectral', title: 'colors.spectral' },
        { value: 'approximate', title: 'colors.approximate' },
      ],
    },
    dopplerMix: {
      kind: 'number',
      title: 'param.dopplerMix',
      help: 'param.dopplerMix.help',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      physical: 1,
    },
    beaming: {
      kind: 'number',
      title: 'param.beaming',
      help: 'param.beaming.help',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      physical: 1,
    },
    ...rasterizing,
  },
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, params) => ({ gbuffer: { ...view, ...params } }),
});
