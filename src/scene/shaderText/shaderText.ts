import { checkCost } from './cost.ts';
import { parse } from './parse.ts';
import type { ShaderProgram } from './program.ts';
import { typeCheck } from './typeCheck.ts';

/**
 * Reads an effect that somebody wrote: WGSL, of which one function `fn effect(p: Pixel) -> vec4f` gives a pixel's colour. It may have functions and constants of
 * its own, numbers, vectors and matrices of f32 and i32, `if` and `for`; it knows `p.position`, `p.uv`, `p.size`, `p.direction`, `p.color`, arg1 … arg4 and
 * time, and looks about by image(offset), depth(offset), normal(offset) … (`SHADER_CHANNELS`), offsets in whole pixels as vec2i. The same program is run by the
 * reference and made into shaders of both backends, so that a text never reaches a compiler of the GPU, and all that can be wrong is told here.
 * Throws a `ShaderTextError` with its line and column. Every loop's count must be known; `SHADER_TEXT_LIMITS` bounds what a pixel may take.
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
