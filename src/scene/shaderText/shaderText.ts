import { check } from './check.ts';
import { boundedReads } from './cost.ts';
import { parse } from './parse.ts';
import type { Program } from './program.ts';

/**
 * Reads an effect that somebody wrote: WGSL, of which one function `fn effect(p: Pixel) -> vec4f` gives a pixel's colour. It may have functions and constants of
 * its own, numbers, vectors and matrices of f32 and i32, `if` and `for`; it knows `p.position`, `p.uv`, `p.size`, `p.direction`, `p.color`, arg1 … arg4 and
 * time, and looks about by image(offset), depth(offset), normal(offset) … (`CHANNELS`), offsets in whole pixels as vec2i. The same program is run by the
 * reference and made into shaders of both backends, so that a text never reaches a compiler of the GPU, and all that can be wrong is told here.
 * Throws a `ShaderTextError` with its line and column. Every loop's count must be known; `LIMITS` bounds what a pixel may take.
 */
export function readShaderText(text: string): Program {
  const syntax = parse(text);
  const checked = check(syntax);
  return {
    ...checked,
    reads: boundedReads(
      checked,
      syntax.functions.map(({ at }) => at),
    ),
  };
}
