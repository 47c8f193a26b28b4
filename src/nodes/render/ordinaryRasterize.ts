import { defineNode } from '../defineNode.ts';
import { rasterizeParams } from './rasterizeParams.ts';

/** What a non-relativistic renderer draws of the same scene: light delay, aberration and Doppler shift are off. */
export const rasterizeNode = defineNode({
  id: 'rasterize',
  title: 'node.rasterizeOrdinary',
  help: 'node.rasterizeOrdinary.help',
  category: 'render',
  params: {
    ...rasterizeParams,
  },
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, { antialiasing, grid }) => ({
    gbuffer: { ...view, view: 'galilean', colors: 'spectral', dopplerMix: 0, beaming: 0, antialiasing, grid },
  }),
});
