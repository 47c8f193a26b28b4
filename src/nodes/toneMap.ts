import { defineNode } from './define.ts';

/** Brings linear light to what a screen can show. */
export const toneMap = defineNode({
  id: 'tone-map',
  title: 'node.toneMap',
  help: 'node.toneMap.help',
  category: 'render',
  params: {
    tone: {
      kind: 'choice',
      title: 'param.tone',
      help: 'param.tone.help',
      default: 'neutral',
      options: [
        { value: 'neutral', title: 'tone.neutral' },
        { value: 'agx', title: 'tone.agx' },
        { value: 'linear', title: 'tone.linear' },
      ],
    },
    exposure: {
      kind: 'number',
      title: 'param.exposure',
      help: 'param.exposure.help',
      unit: 'EV',
      default: 0,
      min: -10,
      max: 10,
      step: 0.1,
    },
    adapt: { kind: 'boolean', title: 'param.adapt', help: 'param.adapt.help', default: true },
  },
  inputs: { gbuffer: { type: 'gbuffer' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ gbuffer }, params) => ({ image: { ...gbuffer, ...params } }),
});
