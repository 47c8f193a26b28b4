import { msg } from '../../messages/message.ts';
import { defineNode } from '../defineNode.ts';
import { primaryGBuffer } from '../frameGraph/buildFrameGraph.ts';
import { CUSTOM, customEffect, customEffectParams } from './customEffect.ts';

const EXAMPLE = `// The darker of the two images.
fn effect(p: Pixel) -> vec4f {
  return mix(p.color, min(p.color, image2(vec2i(0))), arg1);
}
`;

/** Blends two images. */
export const mixColorNode = defineNode({
  id: 'mix-color',
  title: msg`Mix colour`,
  help: msg`Blends two images. Split shows them side by side, wipe moves the border between them, inset shows the upper one small in a corner, and a custom mode is what you write.`,
  category: 'render',
  params: {
    mode: {
      kind: 'choice',
      title: msg`Mode`,
      help: msg`Blends linear light: values brighter than white are kept.`,
      default: 'normal',
      options: [
        { value: 'normal', title: msg`Normal` },
        { value: 'multiply', title: msg`Multiply` },
        { value: 'add', title: msg`Add` },
        { value: 'screen', title: msg`Screen` },
        { value: 'overlay', title: msg`Overlay` },
        { value: 'difference', title: msg`Difference` },
        { value: 'split', title: msg`Split` },
        { value: 'wipe', title: msg`Wipe` },
        { value: 'inset', title: msg`Inset` },
        { value: CUSTOM, title: msg`Custom` },
      ],
    },
    alpha: {
      kind: 'number',
      title: msg`Alpha`,
      help: msg`Opacity of the upper image; for split and wipe, position of the border; for inset, its share of the picture’s width.`,
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
    },
    ...customEffectParams(
      'mode',
      EXAMPLE,
      msg`WGSL: fn effect(p: Pixel) -> vec4f returns the colour of a pixel, from image(offset), which is below, image2(offset), which is above, and arg1, which is alpha. Or GLSL with a void main().`,
    ),
  },
  inputs: {
    below: { type: 'image', title: msg`Below` },
    above: { type: 'image', title: msg`Above` },
    mask: { type: 'mask', optional: true },
  },
  outputs: { image: { type: 'image' } },
  async evaluate({ below, above, mask }, { mode, alpha, text, file }, { node, services }) {
    const gbuffer = primaryGBuffer(below.gbuffer, above.gbuffer);
    const masked = mask && { mask };
    if (mode !== CUSTOM) return { image: { step: { kind: 'mix', mode, alpha, below, above, ...masked }, gbuffer } };
    const effect = await customEffect({ text, file }, true, node, services);
    const images = { image: below, second: above, buffer: gbuffer, ...masked };
    return { image: { step: { kind: 'effect', effect, args: [alpha], ...images }, gbuffer } };
  },
});
