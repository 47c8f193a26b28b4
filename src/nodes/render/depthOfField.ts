import { EFFECTS } from '../../scene/frameGraph/effects.ts';
import { defineNode } from '../defineNode.ts';

const { title, help, args } = EFFECTS['depth-of-field'];
const [focus, aperture, mostBlur] = args;

/** Depth of field: a lens focused at one distance. */
export const depthOfFieldNode = defineNode({
  id: 'depth-of-field',
  title,
  help,
  category: 'render',
  params: {
    focus: { kind: 'number', ...focus },
    aperture: { kind: 'number', ...aperture },
    mostBlur: { kind: 'number', ...mostBlur },
  },
  inputs: { image: { type: 'image' }, gbuffer: { type: 'gbuffer', optional: true } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ image, gbuffer = image.gbuffer }, params) => ({
    image: {
      step: {
        kind: 'effect',
        effect: 'depth-of-field',
        args: [params.focus, params.aperture, params.mostBlur],
        image,
        buffer: gbuffer,
      },
      gbuffer: image.gbuffer,
    },
  }),
});
