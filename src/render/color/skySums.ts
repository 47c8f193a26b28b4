import { dot, float, max, vec3, vec4 } from 'three/tsl';
import { type SkyPartNodes, skyParts } from '../../shaders/color/skyParts.ts';
import { filteredColor } from '../../shaders/tables/spectrumTable.ts';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { SCATTERED_COLOR, SCATTERED_PROJECTION } from '../../spectrum/color/scatteredLight.ts';
import { type DaylightTable, SKY_LIGHTS, skyBandsAtRest } from './daylightTable.ts';
import type { SpectralFilterNodes } from './radiance.ts';

/** Sums of the lights that skies are composed of: as surfaces reflect them, and as the sky itself is seen. */
export interface SkySums {
  addReflected(share: SpectralFilterNodes, luminances: readonly Float[]): void;
  addEmitted(luminances: readonly Float[]): void;
  atRest(): Vec3;
  shifted(D: Float): Vec3;
}

/** Decomposes the light of a sky; `reddenedSky`: it may be red, and not only blue. */
export function decomposeSky(light: Vec3, reddenedSky: boolean): SkyPartNodes {
  if (reddenedSky) return skyParts(light);
  const luminance = max(dot(light, vec3(...SCATTERED_PROJECTION)), 0).toVar();
  return { luminances: [luminance], rest: light.sub(vec3(...SCATTERED_COLOR).mul(luminance)).toVar() };
}

/** `daylight`: present if anything is shifted. */
export function skySums(reddenedSky: boolean, daylight?: DaylightTable): SkySums {
  const sums = Array.from({ length: reddenedSky ? SKY_LIGHTS.length : 1 }, () => ({
    sent: vec4(0).toVar(),
    own: float(0).toVar(),
  }));
  // Most pixels need only one of the two sums.
  let [reflects, emits] = [false, false];
  const all = (parts: readonly Vec3[]): Vec3 => parts.reduce((sum, part) => sum.add(part));
  return {
    addReflected: (reflectance, luminances) => {
      reflects = true;
      sums.forEach(({ sent: reflected }, i) => {
        reflected.addAssign(reflectance.mul(luminances[i]));
      });
    },
    addEmitted: (luminances) => {
      emits = true;
      sums.forEach(({ own: emitted }, i) => {
        emitted.addAssign(luminances[i]);
      });
    },
    atRest: () =>
      all(
        sums.map(({ sent: reflected, own: emitted }, i) => {
          const [red, green, blue] = skyBandsAtRest(i).map((band) => vec3(...band));
          return filteredColor({ red, green, blue }, reflected).add(vec3(...SKY_LIGHTS[i].color).mul(emitted));
        }),
      ),
    shifted: (D) =>
      all([
        vec3(0),
        ...sums.flatMap(({ sent: reflected, own: emitted }, i) => [
          ...(daylight && reflects ? [filteredColor(daylight.skyBands(i, D), reflected)] : []),
          ...(daylight && emits ? [daylight.skyColors(i, D).mul(emitted)] : []),
        ]),
      ]),
  };
}
