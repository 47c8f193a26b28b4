import { defineNode } from '../define.ts';
import { rasterizing } from './rasterizing.ts';

/** What an ordinary renderer draws of the same scene: light takes no time, and motion changes neither places nor colours. */
export const rasterize = defineNode({
  id: 'rasterize',
  title: 'node.rasterizeOrdinary',
  help: 'node.rasterizeOrdinary.help',
  category: 'render',
  params: {
    ...rasterizing,
  },
  inputs: { view: { type: 'view' } },
  outputs: { gbuffer: { type: 'gbuffer' } },
  evaluate: ({ view }, { antialiasing, grid }) => ({
    gbuffer: { ...view, view: 'galilean', colors: 'spectral', dopplerMix: 0, beaming: 0, antialiasing, grid },
  }),
});
