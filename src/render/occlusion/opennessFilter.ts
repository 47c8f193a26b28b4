import { abs, clamp, Fn, floor, ivec2, max, min, screenCoordinate, select, textureLoad, vec2, vec4 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Vec2, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import { DOWNSAMPLING, type OcclusionView } from './openness.ts';

/** A filter of 5 × 5 texels with half weights at the border, which averages the 4 × 4 sample pattern. */
const FILTER_RADIUS = 2;
const FILTER_OFFSETS = [-2, -1, 0, 1, 2] as const;
/** A texel at this distance from the plane of the surface [texels] is weighted by 1/(1 + sharpness), because it belongs to another surface. */
const MAX_PLANE_DISTANCE = 0.5;
const SHARPNESS = 4;

const gridSizeOf = ({ size }: OcclusionView): Vec2 => floor(size.add(DOWNSAMPLING - 1).div(DOWNSAMPLING));
/** Width of a texel at the distance 1. */
const texelWidth = ({ size, uniforms }: OcclusionView): Float =>
  uniforms.halfTangents.y.mul(2 * DOWNSAMPLING).div(size.y);

/**
 * The mean over the texels of the same surface around each texel, without the sample pattern. 1/distance is linear over a plane in a picture without
 * aberration, and nearly linear with it.
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
    const scale = middle.inverseDistance.mul(texelWidth(view)).mul(MAX_PLANE_DISTANCE).reciprocal().toVar();
    const sum = vec2(middle.openness, 1).toVar();
    for (const y of FILTER_OFFSETS)
      for (const x of FILTER_OFFSETS) {
        if (x === 0 && y === 0) continue;
        const { openness, distance, inverseDistance } = at(x, y);
        const straight = middle.inverseDistance.add(right.mul(x)).add(down.mul(y));
        const error = inverseDistance.sub(straight).mul(scale).div(Math.hypot(x, y)).toVar();
        const weight = (Math.abs(x) === FILTER_RADIUS ? 0.5 : 1) * (Math.abs(y) === FILTER_RADIUS ? 0.5 : 1);
        const planeWeight = select(distance.greaterThan(0), weight, 0).div(error.mul(error).mul(SHARPNESS).add(1));
        sum.addAssign(vec2(openness, 1).mul(planeWeight));
      }
    return vec4(sum.x.div(sum.y), middle.distance, 0, 1);
  })();

interface OpennessTexel {
  readonly openness: Float;
  /** Apparent distance [m]; 0 where there is no surface. */
  readonly distance: Float;
  readonly inverseDistance: Float;
}

/** Upsamples to all pixels from the surrounding texels of the same surface; 1 where there is no surface. */
export const upsampleOpenness = (from: Texture, buffer: GBuffer, view: OcclusionView): Vec4 =>
  Fn(() => {
    const last = gridSizeOf(view).sub(1);
    const pixel = floor(screenCoordinate).toVar();
    const distance = textureLoad(buffer.texture('object'), ivec2(pixel)).y.toVar();
    const base = floor(pixel.div(DOWNSAMPLING)).toVar();
    const fraction = pixel.div(DOWNSAMPLING).sub(base).toVar();
    const texel = distance.mul(texelWidth(view)).toVar();
    const sum = vec2(0).toVar();
    for (const [x, y] of CORNERS) {
      const { x: open, y: texelDistance } = textureLoad(from, ivec2(min(base.add(vec2(x, y)), last))).toVar();
      const bilinear = (x ? fraction.x : fraction.x.oneMinus()).mul(y ? fraction.y : fraction.y.oneMinus()).add(1e-4);
      const error = texelDistance.sub(distance).div(texel).toVar();
      const weight = bilinear.mul(select(texelDistance.greaterThan(0), 1, 0)).div(error.mul(error).add(0.1));
      sum.addAssign(vec2(open, 1).mul(weight));
    }
    const hasSurface = sum.y.greaterThan(0).and(distance.greaterThan(0));
    return vec4(select(hasSurface, clamp(sum.x.div(sum.y), 0, 1), 1), 0, 0, 1);
  })();

const CORNERS = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const;
