import { defineNode } from '../defineNode.ts';

/** False colours for a quantity, over the picture. */
export const falseColorNode = defineNode({
  id: 'false-colour',
  title: 'node.falseColor',
  help: 'node.falseColor.help',
  category: 'render',
  params: {
    of: {
      kind: 'choice',
      title: 'param.falseColor',
      help: 'param.falseColor.help',
      default: 'none',
      options: [
        { value: 'none', title: 'falseColor.none' },
        { value: 'doppler', title: 'falseColor.doppler' },
        { value: 'emission-time', title: 'falseColor.emissionTime' },
        { value: 'radiance', title: 'falseColor.radiance' },
        { value: 'band', title: 'falseColor.band' },
      ],
    },
  },
  inputs: { image: { type: 'image' }, gbuffer: { type: 'gbuffer', optional: true } },
  outputs: { image: { type: 'image' } },
  evaluate({ image, gbuffer = image.gbuffer }, { of }) {
    if (of === 'none') return { image };
    return { image: { step: { kind: 'false-colour', of, image, buffer: gbuffer }, gbuffer: image.gbuffer } };
  },
});
