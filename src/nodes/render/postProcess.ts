import type { NumberParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { EFFECTS, type EffectId, type EffectInfo } from '../../scene/frameGraph/effects.ts';
import { defineNode } from '../defineNode.ts';
import { CUSTOM, customEffect, customEffectParams } from './customEffect.ts';

/** Depth of field has a node of its own. */
const BUILTIN_EFFECTS = [
  'gaussian-blur',
  'bilateral-filter',
  'sky-background',
  'sharpen',
  'bloom',
  'edge',
  'vignette',
  'fog',
  'hue-shift',
  'observer-marks',
  'lens-grid',
] as const satisfies readonly EffectId[];

const EXAMPLE = `// Darker lines, as on an old screen.
fn effect(p: Pixel) -> vec4f {
  let line = 0.5 + 0.5 * cos(p.position.y * arg1);
  return vec4f(p.color.rgb * mix(1, line, arg2), 1);
}
`;

const ARGUMENT_TITLES = [
  msg`Number 1 (arg1)`,
  msg`Number 2 (arg2)`,
  msg`Number 3 (arg3)`,
  msg`Number 4 (arg4)`,
] as const;

/** arg1 … arg4: built-in effects define names, units and ranges of their arguments; custom effects take any numbers. */
function argumentParam(index: 0 | 1 | 2 | 3) {
  const own = BUILTIN_EFFECTS.flatMap((id) => {
    const args: EffectInfo['args'] = EFFECTS[id].args;
    const arg = args[index];
    return arg ? [[id, arg] as const] : [];
  });
  const any = { title: ARGUMENT_TITLES[index]!, default: 0, min: -1e9, max: 1e9, step: 0.01, slider: false } as const;
  const cases = { ...Object.fromEntries(own), [CUSTOM]: any };
  return { kind: 'number', ...any, as: { param: 'effect', cases } } as const satisfies NumberParam;
}

/** Effects that fade distant things. */
const FADES = { param: 'effect', is: ['sky-background', 'fog'] } as const;

/** An effect over an image, which may read the G-buffer. */
export const postProcessNode = defineNode({
  id: 'post-process',
  title: msg`Post process`,
  help: msg`An effect over an image: a built-in one or your own. It can read a second image and the visible surfaces; a mask limits it to where the mask is bright.`,
  category: 'render',
  params: {
    effect: {
      kind: 'choice',
      title: msg`Effect`,
      help: msg`Each effect has its own arguments, arg1 to arg4; values outside their ranges are clamped.`,
      default: 'gaussian-blur',
      options: [
        ...BUILTIN_EFFECTS.map((value) => ({ value, title: EFFECTS[value].title })),
        { value: CUSTOM, title: msg`Custom` },
      ],
    },
    arg1: argumentParam(0),
    arg2: argumentParam(1),
    arg3: argumentParam(2),
    arg4: argumentParam(3),
    fogColor: {
      kind: 'choice',
      title: msg`Distant things fade into`,
      help: msg`Default: the sky in a sky background, grey to haze in fog. The sky: its colours in the same direction, those of a Sky with a gradient, else of a clear day. All are multiplied by the brightness.`,
      default: 'default',
      options: [
        { value: 'default', title: msg`Default` },
        { value: 'sky', title: msg`The sky` },
        { value: 'own', title: msg`Own colour` },
      ],
      onlyWhen: FADES,
    },
    ownFogColor: {
      kind: 'color',
      title: msg`Own colour`,
      default: [0.6, 0.65, 0.7],
      onlyWhen: { param: 'fogColor', is: 'own' },
    },
    ...customEffectParams(
      'effect',
      EXAMPLE,
      msg`WGSL: fn effect(p: Pixel) -> vec4f returns the colour of a pixel, from image(offset), image2(offset), depth(offset), normal(offset), albedo(offset) …, p.uv, arg1 … arg4 and time. Or GLSL with a void main().`,
    ),
  },
  inputs: {
    image: { type: 'image' },
    second: { type: 'image', title: msg`Second image`, optional: true },
    gbuffer: { type: 'gbuffer', optional: true },
    mask: { type: 'mask', optional: true },
  },
  outputs: { image: { type: 'image' } },
  async evaluate(
    { image, second, gbuffer = image.gbuffer, mask },
    { effect, arg1, arg2, arg3, arg4, fogColor, ownFogColor, text, file },
    { node, services },
  ) {
    const isCustom = effect === CUSTOM;
    const step = {
      kind: 'effect',
      effect: isCustom ? await customEffect({ text, file }, second !== undefined, node, services) : effect,
      args: [arg1, arg2, arg3, arg4],
      ...(fogColor !== 'default' &&
        FADES.is.some((id) => id === effect) && { fogColor: fogColor === 'own' ? ownFogColor : fogColor }),
      image,
      buffer: gbuffer,
      ...(second && isCustom && { second }),
      ...(mask && { mask }),
    } as const;
    return { image: { step, gbuffer: image.gbuffer } };
  },
});
