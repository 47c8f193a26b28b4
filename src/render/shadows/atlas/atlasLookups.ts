import { Break, floor, If, int, ivec2, Loop, texture, vec2 } from 'three/tsl';
import type { Float, Int, Vec2 } from '../../../shaders/types.ts';
import type { ShadowAtlas } from './shadowAtlas.ts';

/** What receivers read of a map. */
export type AtlasLookup = Pick<ShadowAtlas, 'heights' | 'edgeRow' | 'cell'>;

/** From each lookup to the next: the golden angle. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/** Height of the highest occluder at a whole place [texels]. */
export function heightAt({ heights }: AtlasLookup, at: Vec2): Float {
  const texel = texture(heights).load(ivec2(at));
  // Else three multiplies the whole numbers by the texture's matrix at every fetch.
  texel.updateMatrix = false;
  return texel.x;
}

/** Height of the highest edge near a place [texels]. */
export const edgeHeightNear = (map: AtlasLookup, place: Vec2): Float =>
  heightAt(map, floor(place.div(map.cell)).add(vec2(0, map.edgeRow)));

/** A loop that is left at its end: one that is left at its beginning a software GPU goes through once more, for nothing (docs/adr/0006-software-gpu.md). */
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
