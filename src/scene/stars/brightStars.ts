import { radians } from '../../math/angle.ts';
import { CATALOGUE } from './catalogue.ts';

/** Point sources at infinity. */
export interface Stars {
  /** Unit, 3 per star, from the observer to the star: +X to the vernal equinox, +Z to the celestial north pole (J2000). */
  readonly directions: Float32Array;
  /** Illuminance on a surface that faces the star, for one at rest among the stars [lx]. */
  readonly illuminances: Float32Array;
  /** Of the blackbody that has its colour [K]. */
  readonly temperatures: Float32Array;
}

const BYTES = 12;
/** Apparent magnitude of 1 lx. Source: Allen's Astrophysical Quantities (4th ed.), §2.3.1: V = −13.98 outside the atmosphere. */
const MAGNITUDE_OF_LUX = -13.98;

let known: Stars | undefined;

/** The stars up to magnitude 6, brightest first. */
export function brightStars(): Stars {
  known ??= decode(Uint8Array.from(atob(CATALOGUE), (character) => character.charCodeAt(0)));
  return known;
}

function decode(bytes: Uint8Array): Stars {
  const view = new DataView(bytes.buffer);
  const count = bytes.length / BYTES;
  const directions = new Float32Array(3 * count);
  const illuminances = new Float32Array(count);
  const temperatures = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const at = BYTES * i;
    const rightAscension = radians(view.getInt32(at, true) / 1e4);
    const declination = radians(view.getInt32(at + 4, true) / 1e4);
    const ring = Math.cos(declination);
    const direction = [ring * Math.cos(rightAscension), ring * Math.sin(rightAscension), Math.sin(declination)];
    directions.set(direction, 3 * i);
    illuminances[i] = illuminanceOf(view.getInt16(at + 8, true) / 100);
    temperatures[i] = temperatureOf(view.getInt16(at + 10, true) / 1000);
  }
  return { directions, illuminances, temperatures };
}

/** Illuminance [lx] of an apparent visual magnitude. */
export const illuminanceOf = (magnitude: number): number => 10 ** (0.4 * (MAGNITUDE_OF_LUX - magnitude));

/** Temperature [K] of a colour index B − V. */
export const temperatureOf = (colorIndex: number): number =>
  4600 * (1 / (0.92 * colorIndex + 1.7) + 1 / (0.92 * colorIndex + 0.62));
