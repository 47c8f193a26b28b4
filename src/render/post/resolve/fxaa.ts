import {
  abs,
  clamp,
  dot,
  Fn,
  If,
  int,
  ivec2,
  max,
  min,
  screenCoordinate,
  screenSize,
  screenUV,
  select,
  texture,
  textureLoad,
  vec2,
  vec3,
} from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Vec2, Vec3, Vec4 } from '../../../shaders/types.ts';

const REDUCE = 1 / 8;
const MIN_REDUCE = 1 / 128;
const SPAN = 8;
/** Least contrast of an edge, in encoded luma. */
const MIN_CONTRAST = 1 / 32;

/**
 * Smooths edges of an sRGB-encoded picture along their direction, except between texels whose fourth component is 0. Source: Lottes, FXAA (NVIDIA 2009), the
 * short variant.
 */
export const fxaa = (picture: Texture): Vec3 =>
  Fn(() => {
    const pixel = vec2(1).div(screenSize).toVar();
    const at = (x: Float, y: Float): Vec3 => texture(picture, screenUV.add(pixel.mul(vec2(x, y)))).level(int(0)).rgb;
    // Whole texels are loaded, because filtering is slow on a software GPU.
    const last = screenSize.sub(0.5).toVar();
    const texel = (x: number, y: number): Vec4 =>
      textureLoad(picture, ivec2(clamp(screenCoordinate.add(vec2(x, y)), vec2(0.5), last))).toVar();
    const luma = (rgb: Vec3): Float => dot(rgb, vec3(0.299, 0.587, 0.114)).toVar();
    const here = texel(0, 0);
    const middle = here.rgb.toVar();
    const m = luma(middle);
    const around = [texel(-1, -1), texel(1, -1), texel(-1, 1), texel(1, 1)];
    const [nw, ne, sw, se] = around.map(({ rgb }) => luma(rgb));
    const edged = around.reduce((most, { w }) => max(most, w), here.w).greaterThan(0.5);
    const darkest = min(m, min(min(nw, ne), min(sw, se))).toVar();
    const brightest = max(m, max(max(nw, ne), max(sw, se))).toVar();

    const smooth = middle.toVar();
    If(edged.and(brightest.sub(darkest).greaterThan(MIN_CONTRAST)), () => {
      const direction = vec2(sw.add(se).sub(nw).sub(ne), nw.add(sw).sub(ne).sub(se)).toVar();
      const reduce = max(
        nw
          .add(ne)
          .add(sw)
          .add(se)
          .mul(0.25 * REDUCE),
        MIN_REDUCE,
      );
      const shortest = min(abs(direction.x), abs(direction.y)).add(reduce);
      const step: Vec2 = direction.div(shortest).clamp(-SPAN, SPAN).toVar();
      const along = (k: number): Vec3 => at(step.x.mul(k), step.y.mul(k));
      const near = along(-1 / 6)
        .add(along(1 / 6))
        .mul(0.5)
        .toVar();
      const wide = near
        .mul(0.5)
        .add(along(-0.5).add(along(0.5)).mul(0.25))
        .toVar();
      const wideLuma = luma(wide);
      smooth.assign(select(wideLuma.lessThan(darkest).or(wideLuma.greaterThan(brightest)), near, wide));
    });
    return smooth;
  })();
