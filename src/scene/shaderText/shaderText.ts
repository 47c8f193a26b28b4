import { checkCost } from './cost.ts';
import { inGlsl } from './glsl/inGlsl.ts';
import { isGlsl } from './glsl/isGlsl.ts';
import { parseGlsl } from './glsl/parseGlsl.ts';
import { parse } from './parse.ts';
import type { ShaderProgram } from './program.ts';
import { ShaderTextError } from './sourceLocation.ts';
import type { ModuleSyntax } from './syntax.ts';
import { typeCheck } from './typeCheck.ts';

/**
 * Parses a user-written effect. In a subset of WGSL it has a `fn effect(p: Pixel) -> vec4f`, which returns a pixel's
 * colour. It may declare functions and constants, use f32 and i32 scalars, vectors and matrices, `if` and `for`; inputs
 * are `p.position`, `p.uv`, `p.size`, `p.direction`, `p.color`, arg1 … arg4 and time, and it samples image(offset),
 * depth(offset), normal(offset) … (`SHADER_CHANNELS`), offsets in whole pixels as vec2i. In a subset of GLSL it has a
 * `void main()` (`isGlsl`) and reads uniforms and samplers (glsl/shaderInterface.ts). Either way the same program is
 * evaluated by the reference and compiled to shaders of both backends, so user text never reaches a GPU compiler and
 * every error is reported here. Throws a `ShaderTextError` with line and column. Loop counts must be constant;
 * `SHADER_TEXT_LIMITS` bounds the cost per pixel.
 */
export function readShaderText(text: string): ShaderProgram {
  if (!isGlsl(text)) return checked(parse(text));
  try {
    return checked(parseGlsl(text));
  } catch (error) {
    throw error instanceof ShaderTextError ? inGlsl(error) : error;
  }
}

function checked(syntax: ModuleSyntax): ShaderProgram {
  const program = typeCheck(syntax);
  return {
    ...program,
    reads: checkCost(
      program,
      syntax.functions.map(({ at }) => at),
    ),
  };
}
