import { msg } from '../../messages/message.ts';
import { CAPTURE_TEXELS, DEFAULT_CAPTURE } from '../../scene/view/capture.ts';
import { defineNode } from '../defineNode.ts';

/** Takes what the observer sees from six faces around him that are drawn once for all velocities. */
export const captureNode = defineNode({
  id: 'capture',
  title: msg`Capture`,
  help: msg`Draws what surrounds the observer once, as he would see it at rest, and takes from it what he sees at any velocity and in any direction: the surfaces and their events are the same. Light is computed anew. While he moves, what is near, and what moves itself, is drawn as ever. Use Relativity rasterize for it.`,
  category: 'render',
  params: {
    texels: {
      kind: 'number',
      title: msg`Texels`,
      help: msg`Side of each of the six faces. Behind a fast observer directions are spread apart, and a texel covers several pixels. 0: as fine as the picture.`,
      unit: 'px',
      default: DEFAULT_CAPTURE.texels,
      min: 0,
      max: CAPTURE_TEXELS.max,
      step: 1,
      integer: true,
    },
    maxError: {
      kind: 'number',
      title: msg`Greatest error`,
      help: msg`When anything would be farther beside its place in the picture because the observer has moved, it is drawn anew.`,
      unit: 'px',
      default: DEFAULT_CAPTURE.maxError,
      min: 0.01,
      max: 100,
      step: 0.1,
      scale: 'log',
    },
  },
  inputs: { view: { type: 'view' } },
  outputs: { view: { type: 'view' } },
  evaluate: ({ view }, capture) => ({ view: { ...view, capture } }),
});
