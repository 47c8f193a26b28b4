import { abs, dot, If, vec3 } from 'three/tsl';
import type { Vec3 } from '../../shaders/types.ts';
import { bandOverlaps, pairedBands } from '../../spectrum/doppler/filterPairs.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import type { Overlaps } from './daylightTable.ts';
import type { SpectralFilterNodes } from './radiance.ts';

/**
 * The correction for coloured lights on coloured surfaces, which is not the product of their bands: Σ (a_i − a_j)(k_i − k_j) C_ij over rg, gb and br
 * (filterPairs.ts; docs/physics.md §7.6).
 */
export interface OverlapSum {
  /** Whether any light has been added. */
  readonly any: boolean;
  add(light: Vec3, reflectance: SpectralFilterNodes): void;
  /** Linear sRGB to be subtracted, in daylight at rest. */
  atRest(): Vec3;
  /** The same for a shift, whose colours are only evaluated where the sum is not negligible. */
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
    add: (light, reflectance) => {
      any = true;
      sum.addAssign(reflectance.xyz.sub(reflectance.yzx).mul(light.sub(light.yzx)));
    },
    atRest: () => {
      const [rg, gb, br] = bandOverlaps(DAYLIGHT.temperature, pairedBands(1, 3));
      return through([vec3(...rg), vec3(...gb), vec3(...br)]);
    },
    shifted: (colors) => {
      const shifted = vec3(0).toVar();
      If(dot(abs(sum), vec3(1)).greaterThan(MIN_OVERLAP), () => {
        shifted.assign(through(colors()));
      });
      return shifted;
    },
  };
}

/** Sums below this are invisible; most surfaces are nearly grey. */
const MIN_OVERLAP = 1e-5;
