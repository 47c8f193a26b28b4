import { NodeRefusal, type ParamSpec, type TextParam } from '../../graph/nodeType.ts';
import { type Message, msg } from '../../messages/message.ts';
import type { CustomEffect } from '../../scene/frameGraph/frameGraph.ts';
import { SHADER_TEXT_LIMITS, ShaderTextError } from '../../scene/shaderText/sourceLocation.ts';
import { nodeRefusal, readOrRefuse } from '../common/params.ts';
import type { Services } from '../services.ts';

/** The choice that stands for a user's own text. */
export const CUSTOM = 'written';

/** Parameters of nodes with effects written by users. `param`: the one that chooses `CUSTOM`. */
export function customEffectParams(param: string, example: string, help: TextParam['help']) {
  const onlyWhen = { param, is: CUSTOM } as const;
  return {
    text: {
      kind: 'text',
      title: msg`Shader text`,
      ...(help && { help }),
      default: example,
      shader: true,
      onlyWhen,
    },
    file: {
      kind: 'text',
      title: msg`Shader file`,
      help: msg`A file with the text, in WGSL or GLSL, such as blur.fs; it comes before the text above.`,
      default: '',
      file: true,
      onlyWhen,
    },
  } as const satisfies Readonly<Record<string, ParamSpec>>;
}

interface EffectSource {
  readonly text: string;
  readonly file: string;
}

/** The effect of a text or a file. Throws a NodeRefusal with line and column of the error, or if it reads a second image that is not there. */
export async function customEffect(
  { text, file }: EffectSource,
  hasSecond: boolean,
  node: string,
  services: Services,
): Promise<CustomEffect> {
  const source = file === '' ? text : await readText(file, node, services);
  const refuse = (message: Message): never => {
    throw new NodeRefusal({
      ...{ severity: 'error', code: 'shader.text', place: node },
      message: file === '' ? message : msg`${file}: ${message}`,
    });
  };
  const { readShaderText } = await import('../../scene/shaderText/shaderText.ts');
  try {
    const program = readShaderText(source);
    if (program.reads.includes('image2') && !hasSecond)
      refuse(msg`the text reads a second image, and none is connected: connect one to “Second image”`);
    return { text: source, program };
  } catch (error) {
    return error instanceof ShaderTextError ? refuse(error.text) : rethrow(error);
  }
}

const rethrow = (error: unknown): never => {
  throw error;
};

async function readText(file: string, node: string, services: Services): Promise<string> {
  const bytes = await readOrRefuse(() => services.readFile(file), { node, param: 'file', value: '' });
  // Every character has a byte at least; more is refused before it is decoded.
  if (bytes.length > 4 * SHADER_TEXT_LIMITS.length)
    throw nodeRefusal(
      'shader.text',
      node,
      msg`${file} has ${bytes.length} bytes; a shader text has ${SHADER_TEXT_LIMITS.length} characters at most`,
    );
  return new TextDecoder().decode(bytes);
}
