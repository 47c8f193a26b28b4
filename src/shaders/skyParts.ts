import { dot, max, min, select, vec3 } from 'three/tsl';
import { BLUE_SHARES, RED_SHARES, REDDENED_COLORS, SCATTERED_COLOR } from '../spectrum/scatteredLight.ts';
import type { Float, Vec3 } from './types.ts';

/** What the light of a sky is made of: luminances of scattered, mildly and deeply reddened light; `rest`: a filter before daylight. */
export interface SkyParts {
  readonly luminances: readonly Float[];
  readonly rest: Vec3;
}

/** Twin of `skyParts` of spectrum/scatteredLight.ts. */
export function skyParts(rgb: Vec3): SkyParts {
  const blue = dot(rgb, vec3(...BLUE_SHARES[0])).toVar();
  const mild = select(blue.greaterThan(0), 0, dot(rgb, vec3(...RED_SHARES[0])));
  const deep = select(blue.greaterThan(0), dot(rgb, vec3(...BLUE_SHARES[1])), dot(rgb, vec3(...RED_SHARES[1])));
  const shares = vec3(max(blue, 0), max(mild, 0), max(deep, 0)).toVar();
  const sum = vec3(...SCATTERED_COLOR)
    .mul(shares.x)
    .add(vec3(...REDDENED_COLORS[0]).mul(shares.y))
    .add(vec3(...REDDENED_COLORS[1]).mul(shares.z))
    .toVar();
  const reach = rgb.div(max(max(sum, rgb), 1e-9)).toVar();
  const most = min(min(reach.x, reach.y), min(reach.z, 1)).toVar();
  const luminances = shares.mul(most).toVar();
  return { luminances: [luminances.x, luminances.y, luminances.z], rest: rgb.sub(sum.mul(most)).toVar() };
}
