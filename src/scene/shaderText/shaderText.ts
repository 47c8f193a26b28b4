import { checkCost } from './cost.ts';
import { parse } from './parse.ts';
import type { ShaderProgram } from './program.ts';
import { typeCheck } from './typeCheck.ts';

/**
 * Parses a user-written effect: a subset of WGSL with `fn effect(p: Pixel) -> vec4f`, which returns a pixel's colour.
 * It may declare functions and constants, use f32 and i32 scalars, vectors and matrices, `if` and `for`; inputs are
 * `p.position`, `p.uv`, `p.size`, `p.direction`, `p.color`, arg1 … arg4 and time, and it samples image(offset),
 * depth(offset), normal(offset) … (`SHADER_CHANNELS`), offsets in whole pixels as vec2i. The same program is
 * evaluated by the reference and compiled to shaders of both backends, so user text never reaches a GPU compiler and
 * every error is reported here. Throws a `ShaderTextError` with line and column. Loop counts must be constant;
 * `SHADER_TEXT_LIMITS` bounds the cost per pixel.
 */
export function readShaderText(text: string): ShaderProgram {
  const syntax = parse(text);
  const checked = typeCheck(syntax);
  return {
    ...checked,
    reads: checkCost(
      checked,
      syntax.functions.map(({ at }) => at),
    ),
  };
}
