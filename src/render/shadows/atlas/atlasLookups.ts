import { Break, floor, If, int, ivec2, Loop, texture, vec2 } from 'three/tsl';
import type { Float, Int, Vec2 } from '../../../shaders/types.ts';
import type { ShadowAtlas } from './shadowAtlas.ts';

/** What receivers read of a shadow atlas. */
export type AtlasLookup = Pick<ShadowAtlas, 'heights' | 'edgeRow' | 'cell'>;

/** Angle between successive lookups. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
/** How far a receiver is moved along its normal [texels]: always, and in addition where light is at grazing incidence. */
export const NORMAL_BIAS = [0.4, 1.1] as const;
/** Steepest slope of the receiver, across the light, that is followed under the filter. */
export const MAX_SLOPE = 8;
/** What rises beside the receiver less steeply than this, such as the floor at the foot of a wall, is not above it. */
export const MIN_OCCLUDER_SLOPE = 1.5;
/** Least radius of the projected light [texels]; the largest is a cell of the edge map. */
export const MIN_FILTER_RADIUS = 0.8;

/** Height of the highest occluder at a texel (integer coordinates) [texels]. */
export function heightAt({ heights }: AtlasLookup, at: Vec2): Float {
  const texel = texture(heights).load(ivec2(at));
  // Otherwise three.js multiplies the integer coordinates by the texture's matrix at every fetch.
  texel.updateMatrix = false;
  return texel.x;
}

/** Height of the highest edge near a place [texels]. */
export const edgeHeightNear = (map: AtlasLookup, place: Vec2): Float =>
  heightAt(map, floor(place.div(map.cell)).add(vec2(0, map.edgeRow)));

/** A loop whose exit test is at its end: with the test at the beginning, a software GPU runs the body once more for nothing (docs/adr/0006-software-gpu.md). */
export function loopTimes(count: Int, body: (i: Int) => void): void {
  Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i }) => {
    const index = int(i);
    body(index);
    If(index.add(int(1)).greaterThanEqual(count), () => {
      Break();
    });
  });
}

export const rotateByGoldenAngle = ({ x, y }: Vec2): Vec2 => {
  const [cos, sin] = [Math.cos(GOLDEN_ANGLE), Math.sin(GOLDEN_ANGLE)];
  return vec2(x.mul(cos).sub(y.mul(sin)), x.mul(sin).add(y.mul(cos)));
};
