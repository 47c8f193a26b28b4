import { float, vec3, vec4 } from 'three/tsl';
import { filteredColor } from '../shaders/spectrumTable.ts';
import type { Float, Vec3 } from '../shaders/types.ts';
import { type DaylightColors, type DaylightTable, SKY_LIGHTS } from './daylightTable.ts';
import type { Filter } from './radiance.ts';

/** What came of the lights of skies: as surfaces send it, and as the sky itself is seen. */
export interface SkySums {
  send(share: Filter, luminances: readonly Float[]): void;
  emit(luminances: readonly Float[]): void;
  atRest(): Vec3;
  shifted(D: Float, colors: DaylightColors['colors']): Vec3;
}

/** `count`: of so many of `SKY_LIGHTS`. */
export function skySums(ofDay: DaylightTable, count: number): SkySums {
  const sums = Array.from({ length: count }, () => ({ sent: vec4(0).toVar(), own: float(0).toVar() }));
  // Most pixels have one of the two.
  let [sends, emits] = [false, false];
  const all = (parts: readonly Vec3[]): Vec3 => parts.reduce((sum, part) => sum.add(part));
  return {
    send: (share, luminances) => {
      sends = true;
      sums.forEach(({ sent }, i) => {
        sent.addAssign(share.mul(luminances[i]));
      });
    },
    emit: (luminances) => {
      emits = true;
      sums.forEach(({ own }, i) => {
        own.addAssign(luminances[i]);
      });
    },
    atRest: () => all(sums.map(({ sent, own }, i) => sent.xyz.add(own).mul(vec3(...SKY_LIGHTS[i].color)))),
    shifted: (D, colors) =>
      all([
        vec3(0),
        ...sums.flatMap(({ sent, own }, i) => [
          ...(sends ? [filteredColor(colors, sent).mul(ofDay.skyOfDaylight(i, D))] : []),
          ...(emits ? [ofDay.skySeen(i, D).mul(own)] : []),
        ]),
      ]),
  };
}
