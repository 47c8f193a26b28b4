import { abs, clamp, Fn, floor, ivec2, max, min, screenCoordinate, select, textureLoad, vec2, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Vec2, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../targets.ts';
import { COARSENESS, type OcclusionView } from './visibility.ts';

/** Weights of five texels in a line, of which every four neighbours have all of the pattern's places. */
const WEIGHTS = [0.5, 1, 1, 1, 0.5] as const;
const MIDDLE = 2;
/** So far from where the surface would go on straight [texels], and it is another one. */
const APART = 0.5;

const texelsOf = ({ size }: OcclusionView): Vec2 => floor(size.add(COARSENESS - 1).div(COARSENESS));
/** A texel's breadth at the distance 1. */
const breadthOf = ({ size, uniforms }: OcclusionView): Float => uniforms.halfTangents.y.mul(2 * COARSENESS).div(size.y);

/**
 * The mean of what is on the same surface along a row or a column: after both, no pattern is left. 1/distance goes straight over a plane in any
 * picture, and nearly so where aberration bends it.
 */
export const smoothed = (from: Texture, step: readonly [number, number], view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = texelsOf(view).sub(1);
    const here = floor(screenCoordinate);
    const texels = WEIGHTS.map((_, k) =>
      textureLoad(from, ivec2(clamp(here.add(vec2(...step).mul(k - MIDDLE)), vec2(0), last))).toVar(),
    );
    const near = texels.map(({ y }) => max(y, 1e-20).reciprocal().toVar());
    const [before, after] = [near[2].sub(near[1]).toVar(), near[3].sub(near[2]).toVar()];
    const slope = select(abs(before).lessThan(abs(after)), before, after).toVar();
    const texel = near[MIDDLE].mul(breadthOf(view)).mul(APART).toVar();
    const sum = vec2(texels[MIDDLE].x, 1).toVar();
    WEIGHTS.forEach((weight, k) => {
      const away = k - MIDDLE;
      if (away === 0) return;
      const off = abs(near[k].sub(near[MIDDLE]).sub(slope.mul(away))).div(texel.mul(Math.abs(away)));
      const share = select(texels[k].y.greaterThan(0), weight, 0).div(off.mul(off).mul(4).add(1));
      sum.addAssign(vec2(texels[k].x, 1).mul(share));
    });
    return vec4(sum.x.div(sum.y), texels[MIDDLE].y, 0, 1);
  })();

/** Brought to every pixel, from the texels around that show the same surface; 1 where nothing is. */
export const spread = (from: Texture, buffer: GBuffer, view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = texelsOf(view).sub(1);
    const pixel = floor(screenCoordinate).toVar();
    const distance = textureLoad(buffer.texture('object'), ivec2(pixel)).y.toVar();
    const base = floor(pixel.div(COARSENESS)).toVar();
    const part = pixel.div(COARSENESS).sub(base).toVar();
    const texel = distance.mul(breadthOf(view)).toVar();
    const sum = vec2(0).toVar();
    for (const [x, y] of CORNERS) {
      const { x: open, y: there } = textureLoad(from, ivec2(min(base.add(vec2(x, y)), last))).toVar();
      const bilinear = (x ? part.x : part.x.oneMinus()).mul(y ? part.y : part.y.oneMinus()).add(1e-4);
      const off = there.sub(distance).div(texel).toVar();
      const share = bilinear.mul(select(there.greaterThan(0), 1, 0)).div(off.mul(off).add(0.1));
      sum.addAssign(vec2(open, 1).mul(share));
    }
    const known = sum.y.greaterThan(0).and(distance.greaterThan(0));
    return vec4(select(known, clamp(sum.x.div(sum.y), 0, 1), 1), 0, 0, 1);
  })();

const CORNERS = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const;
