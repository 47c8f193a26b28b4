import { NodeRefusal, type NumberParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { EFFECTS, type EffectId, type EffectInfo } from '../../scene/frameGraph/effects.ts';
import type { CustomEffect } from '../../scene/frameGraph/frameGraph.ts';
import { readShaderText } from '../../scene/shaderText/shaderText.ts';
import { ShaderTextError } from '../../scene/shaderText/sourceLocation.ts';
import { defineNode } from '../defineNode.ts';

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
] as const satisfies readonly EffectId[];
const CUSTOM_EFFECT = 'written';

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
  const cases = { ...Object.fromEntries(own), [CUSTOM_EFFECT]: any };
  return { kind: 'number', ...any, as: { param: 'effect', cases } } as const satisfies NumberParam;
}

/** An effect over an image, which may read the G-buffer. */
export const postProcessNode = defineNode({
  id: 'post-process',
  title: msg`Post process`,
  help: msg`An effect over an image: a built-in one or your own. It can read the visible surfaces; a mask limits it to where the mask is bright.`,
  category: 'render',
  params: {
    effect: {
      kind: 'choice',
      title: msg`Effect`,
      help: msg`Each effect has its own arguments, arg1 to arg4; values outside their ranges are clamped.`,
      default: 'gaussian-blur',
      options: [
        ...BUILTIN_EFFECTS.map((value) => ({ value, title: EFFECTS[value].title })),
        { value: CUSTOM_EFFECT, title: msg`Custom` },
      ],
    },
    arg1: argumentParam(0),
    arg2: argumentParam(1),
    arg3: argumentParam(2),
    arg4: argumentParam(3),
    text: {
      kind: 'text',
      title: msg`Shader text`,
      help: msg`WGSL: fn effect(p: Pixel) -> vec4f returns the colour of a pixel, from image(offset), depth(offset), normal(offset) …, p.uv, arg1 … arg4 and time.`,
      default: EXAMPLE,
      shader: true,
      onlyWhen: { param: 'effect', is: CUSTOM_EFFECT },
    },
  },
  inputs: {
    image: { type: 'image' },
    gbuffer: { type: 'gbuffer', optional: true },
    mask: { type: 'mask', optional: true },
  },
  outputs: { image: { type: 'image' } },
  evaluate({ image, gbuffer = image.gbuffer, mask }, { effect, arg1, arg2, arg3, arg4, text }, { node }) {
    const step = {
      kind: 'effect',
      effect: effect === CUSTOM_EFFECT ? parseCustomEffect(text, node) : effect,
      args: [arg1, arg2, arg3, arg4],
      image,
      buffer: gbuffer,
      ...(mask && { mask }),
    } as const;
    return { image: { step, gbuffer: image.gbuffer } };
  },
});

/** Throws a NodeRefusal with line and column of the error. */
function parseCustomEffect(text: string, node: string): CustomEffect {
  try {
    readShaderText(text);
    return { text };
  } catch (error) {
    if (!(error instanceof ShaderTextError)) throw error;
    throw new NodeRefusal({ severity: 'error', code: 'shader.text', place: node, message: error.text });
  }
}
