import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';

/** False colours for a quantity, over the picture. */
export const falseColorNode = defineNode({
  id: 'false-colour',
  title: msg`False colour`,
  help: msg`Shows a quantity as colours with a legend: Doppler factor, emission time, luminance, or the visible part of the emitted spectrum.`,
  category: 'render',
  params: {
    of: {
      kind: 'choice',
      title: msg`False colours`,
      help: msg`Shows a quantity as colours: the Doppler factor D; the emission time; the luminance before exposure; the visible part of the emitted spectrum.`,
      default: 'none',
      options: [
        { value: 'none', title: msg`Off` },
        { value: 'doppler', title: msg`Doppler` },
        { value: 'emission-time', title: msg`Time` },
        { value: 'radiance', title: msg`Light` },
        { value: 'band', title: msg`Band` },
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
