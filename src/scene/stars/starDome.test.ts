import { describe, expect, it } from 'vitest';
import { rotate } from '../../math/quat.ts';
import { dot, normalize, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { aberrate } from '../../physics/optics/aberration.ts';
import { observerDoppler } from '../../physics/optics/doppler.ts';
import { LUMINANCE_WEIGHTS } from '../../spectrum/color/observerColor.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../lights/latLong.ts';
import { sampleTexture } from '../materials/sampleTexture.ts';
import { blackbody } from './blackbody.ts';
import { brightStars } from './brightStars.ts';
import { EQUATORIAL } from './equatorial.ts';
import { starDome } from './starDome.ts';

const GAIN = 40;
const stars = brightStars();
const dome = starDome({ kind: 'stars', path: '/Stars', stars, orientation: EQUATORIAL, gain: GAIN });
const STARS = Array.from(stars.illuminances, (E, i) => ({
  E: GAIN * E,
  T: stars.temperatures[i],
  n: rotate(EQUATORIAL, [...stars.directions.subarray(3 * i, 3 * i + 3)] as unknown as Vec3),
}));

/** Directions of the world, and the luminance of the dome times the solid angle of each, by blackbody. */
const CELLS = ((): { n: Vec3; E: number; T: number }[] => {
  const [W, H] = [256, 128];
  const { texture, color, blackbodies } = dome;
  const [x, y, z] = domeAxes(dome);
  if (!texture || !blackbodies) throw new Error('no stars');
  return Array.from({ length: W * H }, (_, k) => {
    const [column, row] = [k % W, Math.floor(k / W)];
    const [a, b, c] = directionFromLatLong((column + 0.5) / W, 1 - (row + 0.5) / H);
    const n: Vec3 = [0, 1, 2].map((i) => a * x[i] + b * y[i] + c * z[i]) as unknown as Vec3;
    const amounts = sampleTexture(texture, ...latLongFromDirection([a, b, c]));
    const angle = ((2 * Math.PI) / W) * (Math.cos((Math.PI * row) / H) - Math.cos((Math.PI * (row + 1)) / H));
    return blackbodies.map(({ channel, color: factor, spectrum }) => ({
      n,
      E: amounts[channel] * color[channel] * dot(LUMINANCE_WEIGHTS, factor) * angle,
      T: spectrum.temperature,
    }));
  }).flat();
})();

const NORMALS: readonly Vec3[] = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], normalize([1, 2, -2])];

describe('the light of the stars on surfaces', () => {
  it('is in all as much as that of the catalogue', () => {
    const sum = (all: readonly { E: number }[]): number => all.reduce((total, { E }) => total + E, 0);
    expect(Math.abs(sum(CELLS) / sum(STARS) - 1)).toBeLessThan(0.01);
  });

  it.each([0, 0.6, 0.9])('irradiates every normal at %d c as the stars one by one do', (beta) => {
    const u = properVelocity([0, 0.6 * beta, -0.8 * beta]);
    // The sum of E D² cos θ′ (docs/physics.md §6.1).
    const irradiance = (all: typeof CELLS, normal: Vec3): number =>
      all.reduce((sum, { n, E }) => sum + E * observerDoppler(n, u) ** 2 * Math.max(dot(aberrate(n, u), normal), 0), 0);
    for (const normal of NORMALS)
      expect(Math.abs(irradiance(CELLS, normal) / irradiance(STARS, normal) - 1)).toBeLessThan(0.02);
  });

  const shifted = ({ E, T }: { E: number; T: number }, D: number): number =>
    (E * blackbody(T * D).luminance) / blackbody(T).luminance;

  it.each([0.4, 0.5, 0.8, 1, 2, 2.5])('has in all the spectrum of the stars at D = %d', (D) => {
    const luminance = (all: readonly { E: number; T: number }[]): number =>
      all.reduce((sum, light) => sum + shifted(light, D), 0);
    expect(Math.abs(luminance(CELLS) / luminance(STARS) - 1)).toBeLessThan(0.01);
  });

  it.each([
    [0.5, 0.15],
    [0.8, 0.03],
    [1, 0.02],
    [2, 0.03],
  ])('has on every normal the spectrum of the stars that it faces, at D = %d', (D, bound) => {
    const illuminance = (all: typeof CELLS, normal: Vec3): number =>
      all.reduce((sum, light) => sum + shifted(light, D) * Math.max(dot(light.n, normal), 0), 0);
    for (const normal of NORMALS)
      expect(Math.abs(illuminance(CELLS, normal) / illuminance(STARS, normal) - 1)).toBeLessThan(bound);
  });

  it('is none without stars', () => {
    const none = new Float32Array(0);
    const empty = { directions: none, illuminances: none, temperatures: none };
    const sky = { kind: 'stars', path: '', stars: empty, orientation: EQUATORIAL, gain: 1 } as const;
    expect(starDome(sky)).toEqual({ kind: 'dome', path: '', color: [0, 0, 0] });
  });
});
