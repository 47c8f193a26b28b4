import { abs, clamp, Fn, floor, ivec2, max, min, screenCoordinate, select, textureLoad, vec2, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Vec2, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import { DOWNSAMPLING, type OcclusionView } from './openness.ts';

/** Of 5 × 5 texels, those at the rim counted by half, every 4 × 4 have all of the pattern's places. */
const FILTER_RADIUS = 2;
const FILTER_OFFSETS = [-2, -1, 0, 1, 2] as const;
/** So far from where the surface would go on straight [texels], and a texel counts 1/(1 + sharpness): it is another surface's. */
const MAX_PLANE_DISTANCE = 0.5;
const SHARPNESS = 4;

const gridSizeOf = ({ size }: OcclusionView): Vec2 => floor(size.add(DOWNSAMPLING - 1).div(DOWNSAMPLING));
/** A texel's breadth at the distance 1. */
const texelBreadth = ({ size, uniforms }: OcclusionView): Float =>
  uniforms.halfTangents.y.mul(2 * DOWNSAMPLING).div(size.y);

/**
 * The mean of what is on the same surface around each texel, in which no pattern is left. 1/distance goes straight over a plane in any picture, and
 * nearly so where aberration bends it.
 */
export const smoothOpenness = (from: Texture, view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = gridSizeOf(view).sub(1);
    const here = floor(screenCoordinate).toVar();
    const texel = (x: number, y: number): OpennessTexel => {
      const found = textureLoad(from, ivec2(clamp(here.add(vec2(x, y)), vec2(0), last))).toVar();
      return { openness: found.x, distance: found.y, inverseDistance: max(found.y, 1e-20).reciprocal().toVar() };
    };
    const around = FILTER_OFFSETS.map((y) => FILTER_OFFSETS.map((x) => texel(x, y)));
    const at = (x: number, y: number): OpennessTexel => around[y + FILTER_RADIUS]![x + FILTER_RADIUS]!;
    const middle = at(0, 0);
    const slope = (x: number, y: number): Float => {
      const [before, after] = [
        middle.inverseDistance.sub(at(-x, -y).inverseDistance).toVar(),
        at(x, y).inverseDistance.sub(middle.inverseDistance).toVar(),
      ];
      return select(abs(before).lessThan(abs(after)), before, after).toVar();
    };
    const [right, down] = [slope(1, 0), slope(0, 1)];
    const breadth = middle.inverseDistance.mul(texelBreadth(view)).mul(MAX_PLANE_DISTANCE).reciprocal().toVar();
    const sum = vec2(middle.openness, 1).toVar();
    for (const y of FILTER_OFFSETS)
      for (const x of FILTER_OFFSETS) {
        if (x === 0 && y === 0) continue;
        const { openness, distance, inverseDistance } = at(x, y);
        const straight = middle.inverseDistance.add(right.mul(x)).add(down.mul(y));
        const off = inverseDistance.sub(straight).mul(breadth).div(Math.hypot(x, y)).toVar();
        const weight = (Math.abs(x) === FILTER_RADIUS ? 0.5 : 1) * (Math.abs(y) === FILTER_RADIUS ? 0.5 : 1);
        const share = select(distance.greaterThan(0), weight, 0).div(off.mul(off).mul(SHARPNESS).add(1));
        sum.addAssign(vec2(openness, 1).mul(share));
      }
    return vec4(sum.x.div(sum.y), middle.distance, 0, 1);
  })();

interface OpennessTexel {
  readonly openness: Float;
  /** Apparent; 0 where nothing is. */
  readonly distance: Float;
  readonly inverseDistance: Float;
}

/** Brought to every pixel, from the texels around that show the same surface; 1 where nothing is. */
export const upsampleOpenness = (from: Texture, buffer: GBuffer, view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = gridSizeOf(view).sub(1);
    const pixel = floor(screenCoordinate).toVar();
    const distance = textureLoad(buffer.texture('object'), ivec2(pixel)).y.toVar();
    const base = floor(pixel.div(DOWNSAMPLING)).toVar();
    const part = pixel.div(DOWNSAMPLING).sub(base).toVar();
    const texel = distance.mul(texelBreadth(view)).toVar();
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
