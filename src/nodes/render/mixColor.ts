import { MIX_MODES } from '../../scene/effects.ts';
import { defineNode } from '../define.ts';
import { leading } from '../plan.ts';

/** Two images into one. */
export const mixColor = defineNode({
  id: 'mix-color',
  title: 'node.mixColor',
  help: 'node.mixColor.help',
  category: 'render',
  params: {
    mode: {
      kind: 'choice',
      title: 'param.mixMode',
      help: 'param.mixMode.help',
      default: 'normal',
      options: MIX_MODES.map((value) => ({ value, title: `mix.${value}` })),
    },
    alpha: {
      kind: 'number',
      title: 'param.alpha',
      help: 'param.alpha.help',
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
    },
  },
  inputs: {
    below: { type: 'image', title: 'socket.below' },
    above: { type: 'image', title: 'socket.above' },
    mask: { type: 'mask', optional: true },
  },
  outputs: { image: { type: 'image' } },
  evaluate: ({ below, above, mask }, { mode, alpha }) => ({
    image: {
      step: { kind: 'mix', mode, alpha, below, above, ...(mask && { mask }) },
      gbuffer: leading(below.gbuffer, above.gbuffer),
    },
  }),
});
