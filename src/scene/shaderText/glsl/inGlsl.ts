import type { LocalizedText } from '../../../messages/message.ts';
import { ShaderTextError } from '../sourceLocation.ts';

/** GLSL's name of a type, or of the function that `main` becomes. */
function glslName(name: string): string {
  const [, size, letter] = /^vec([234])([fi])$/.exec(name) ?? [];
  if (size) return letter === 'f' ? `vec${size}` : `ivec${size}`;
  const [, matrix] = /^mat([234])x\1f$/.exec(name) ?? [];
  if (matrix) return `mat${matrix}`;
  return { f32: 'float', i32: 'int', effect: 'main', inverseSqrt: 'inversesqrt', atan2: 'atan' }[name] ?? name;
}

const renamed = (text: LocalizedText | number): LocalizedText | number =>
  typeof text === 'string'
    ? glslName(text)
    : typeof text === 'number'
      ? text
      : { template: text.template, values: text.values.map(renamed) };

/** An error of the type checker, which calls types as WGSL does, with the names of GLSL. */
export const inGlsl = (error: ShaderTextError): ShaderTextError =>
  new ShaderTextError(error, { ...error.reason, values: error.reason.values.map(renamed) });
