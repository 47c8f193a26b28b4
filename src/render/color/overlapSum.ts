import { abs, dot, If, vec3 } from 'three/tsl';
import type { Vec3 } from '../../shaders/types.ts';
import { bandOverlaps } from '../../spectrum/doppler/filterPairs.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { Overlaps } from './daylightTable.ts';
import type { SpectralFilterNodes } from './radiance.ts';

/** What coloured lights and coloured surfaces make together beyond the products of their bands: Σ (a_i − a_j)(k_i − k_j) C_ij of rg, gb and br (filterPairs.ts). */
export interface OverlapSum {
  /** Whether any light was added. */
  readonly any: boolean;
  add(light: Vec3, share: SpectralFilterNodes): void;
  /** Linear sRGB, to be taken away; in daylight at rest. */
  atRest(): Vec3;
  /** The same through the colours of a shift, which are only asked for where there is something of them. */
  shifted(colors: () => Overlaps): Vec3;
}

export function overlapSum(): OverlapSum {
  const sum = vec3(0).toVar();
  let any = false;
  const through = ([rg, gb, br]: Overlaps): Vec3 => rg.mul(sum.x).add(gb.mul(sum.y)).add(br.mul(sum.z));
  return {
    get any() {
      return any;
    },
    add: (light, share) => {
      any = true;
      sum.addAssign(share.xyz.sub(share.yzx).mul(light.sub(light.yzx)));
    },
    atRest: () => {
      const [rg, gb, br] = bandOverlaps(DAYLIGHT.temperature, 1, 3);
      return through([vec3(...rg), vec3(...gb), vec3(...br)]);
    },
    shifted: (colors) => {
      const seen = vec3(0).toVar();
      If(dot(abs(sum), vec3(1)).greaterThan(MIN_OVERLAP), () => {
        seen.assign(through(colors()));
      });
      return seen;
    },
  };
}

/** Less of them is not seen, and most surfaces are nearly grey. */
const MIN_OVERLAP = 1e-5;
