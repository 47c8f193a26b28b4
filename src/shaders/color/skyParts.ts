import { dot, max, min, select, vec2, vec3, vec4 } from 'three/tsl';
import { DUSK_SHARES, REDDENED_COLORS, SCATTERED_COLOR } from '../../spectrum/color/scatteredLight.ts';
import type { Float, Vec2, Vec3 } from '../types.ts';

/** Decomposition of sky light: luminances of scattered and of mildly to deeply reddened light; `rest`: a filter before daylight. */
export interface SkyPartNodes {
  readonly luminances: readonly Float[];
  readonly rest: Vec3;
}

/** Twin of `skyParts` in spectrum/color/scatteredLight.ts. docs/physics.md §7.8. */
export function skyParts(rgb: Vec3): SkyPartNodes {
  const [blue, red, yellow] = (['blue', 'red', 'yellow'] as const).map((name): Vec2 => {
    const [a, b] = DUSK_SHARES[name];
    return max(vec2(dot(rgb, vec3(...a)), dot(rgb, vec3(...b))), 0).toVar();
  });
  const ofRed = select(red.y.greaterThan(0), vec4(0, 0, red), vec4(0, yellow, 0));
  const shares = select(blue.x.greaterThan(0), vec4(blue.x, 0, 0, blue.y), ofRed).toVar();
  const sum = [SCATTERED_COLOR, ...REDDENED_COLORS]
    .map((color, i) => vec3(...color).mul([shares.x, shares.y, shares.z, shares.w][i]))
    .reduce((all, part) => all.add(part))
    .toVar();
  const reach = rgb.div(max(max(sum, rgb), 1e-9)).toVar();
  const most = min(min(reach.x, reach.y), min(reach.z, 1)).toVar();
  const luminances = shares.mul(most).toVar();
  return {
    luminances: [luminances.x, luminances.y, luminances.z, luminances.w],
    rest: rgb.sub(sum.mul(most)).toVar(),
  };
}
