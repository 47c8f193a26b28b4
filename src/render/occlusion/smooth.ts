import { abs, clamp, Fn, floor, ivec2, max, min, screenCoordinate, select, textureLoad, vec2, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Vec2, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../targets.ts';
import { COARSENESS, type OcclusionView } from './visibility.ts';

/** Of 5 × 5 texels, those at the rim counted by half, every 4 × 4 have all of the pattern's places. */
const REACH = 2;
const PLACES = [-2, -1, 0, 1, 2] as const;
/** So far from where the surface would go on straight [texels], and a texel counts 1/(1 + sharpness): it is another surface's. */
const APART = 0.5;
const SHARPNESS = 4;

const texelsOf = ({ size }: OcclusionView): Vec2 => floor(size.add(COARSENESS - 1).div(COARSENESS));
/** A texel's breadth at the distance 1. */
const breadthOf = ({ size, uniforms }: OcclusionView): Float => uniforms.halfTangents.y.mul(2 * COARSENESS).div(size.y);

/**
 * The mean of what is on the same surface around each texel, in which no pattern is left. 1/distance goes straight over a plane in any picture, and
 * nearly so where aberration bends it.
 */
export const smoothed = (from: Texture, view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = texelsOf(view).sub(1);
    const here = floor(screenCoordinate).toVar();
    const texel = (x: number, y: number): Texel => {
      const found = textureLoad(from, ivec2(clamp(here.add(vec2(x, y)), vec2(0), last))).toVar();
      return { open: found.x, distance: found.y, near: max(found.y, 1e-20).reciprocal().toVar() };
    };
    const around = PLACES.map((y) => PLACES.map((x) => texel(x, y)));
    const at = (x: number, y: number): Texel => around[y + REACH]![x + REACH]!;
    const middle = at(0, 0);
    const slope = (x: number, y: number): Float => {
      const [before, after] = [middle.near.sub(at(-x, -y).near).toVar(), at(x, y).near.sub(middle.near).toVar()];
      return select(abs(before).lessThan(abs(after)), before, after).toVar();
    };
    const [right, down] = [slope(1, 0), slope(0, 1)];
    const breadth = middle.near.mul(breadthOf(view)).mul(APART).reciprocal().toVar();
    const sum = vec2(middle.open, 1).toVar();
    for (const y of PLACES)
      for (const x of PLACES) {
        if (x === 0 && y === 0) continue;
        const { open, distance, near } = at(x, y);
        const straight = middle.near.add(right.mul(x)).add(down.mul(y));
        const off = near.sub(straight).mul(breadth).div(Math.hypot(x, y)).toVar();
        const weight = (Math.abs(x) === REACH ? 0.5 : 1) * (Math.abs(y) === REACH ? 0.5 : 1);
        const share = select(distance.greaterThan(0), weight, 0).div(off.mul(off).mul(SHARPNESS).add(1));
        sum.addAssign(vec2(open, 1).mul(share));
      }
    return vec4(sum.x.div(sum.y), middle.distance, 0, 1);
  })();

interface Texel {
  readonly open: Float;
  /** Apparent; 0 where nothing is. */
  readonly distance: Float;
  readonly near: Float;
}

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
