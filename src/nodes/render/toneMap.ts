import { defineNode } from '../defineNode.ts';

/** Maps scene-linear radiance to display values. */
export const toneMapNode = defineNode({
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
    metering: {
      kind: 'choice',
      title: 'param.metering',
      help: 'param.metering.help',
      default: 'automatic',
      options: [
        { value: 'automatic', title: 'metering.automatic' },
        { value: 'resting-eye', title: 'metering.restingEye' },
        { value: 'manual', title: 'metering.manual' },
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
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ image }, { tone, metering, exposure }) => ({
    image: { step: { kind: 'tone', tone, metering, exposure, image }, gbuffer: image.gbuffer },
  }),
});
