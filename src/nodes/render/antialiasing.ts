import { EFFECTS } from '../../scene/frameGraph/effects.ts';
import { defineNode } from '../defineNode.ts';

const { title, help, args } = EFFECTS.antialiasing;
const [contrast, search, single] = args;

/** Antialiasing (FXAA) of a finished picture. */
export const antialiasingNode = defineNode({
  id: 'antialiasing',
  title,
  help,
  category: 'render',
  params: {
    contrast: { kind: 'number', ...contrast },
    search: { kind: 'number', ...search, integer: true },
    single: { kind: 'number', ...single },
  },
  inputs: { image: { type: 'image' }, mask: { type: 'mask', optional: true } },
  outputs: { image: { type: 'image' } },
  evaluate: ({ image, mask }, params) => ({
    image: {
      step: {
        kind: 'effect',
        effect: 'antialiasing',
        args: [params.contrast, params.search, params.single],
        image,
        buffer: image.gbuffer,
        ...(mask && { mask }),
      },
      gbuffer: image.gbuffer,
    },
  }),
});
