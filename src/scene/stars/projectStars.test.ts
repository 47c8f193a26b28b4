import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { fromAxisAngle, IDENTITY, type Quat, rotate } from '../../math/quat.ts';
import { normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { perspective } from '../view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../view/view.ts';
import { projectStars } from './projectStars.ts';

const WIDTH = 800;
const HEIGHT = 600;
const SUN_LIKE = 5800;

/** Projects one star: its position [−1 … 1] and light in the picture; undefined outside. */
function seen(toward: Vec3, view: Partial<ViewPoint> = {}, settings: Partial<RenderSettings> = {}) {
  const stars = {
    directions: Float32Array.from(normalize(toward)),
    illuminances: Float32Array.of(1),
    temperatures: Float32Array.of(SUN_LIKE),
  };
  const [places, lights] = [new Float32Array(3), new Float32Array(3)];
  const sky = { kind: 'stars', path: '', stars, orientation: IDENTITY, gain: 1 } as const;
  const at = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, lens: perspective(1), ...view } as const;
  const count = projectStars(sky, at, { ...DEFAULT_SETTINGS, ...settings }, WIDTH, HEIGHT, {
    positions: places,
    radiances: lights,
  });
  return count === 1 ? { x: places[0], y: places[1], luminance: lights[1] } : undefined;
}

/** Solid angle of a pixel in the middle of the picture. */
const PIXEL = ((2 * Math.tan(0.5)) / HEIGHT) ** 2;

describe('a star in a picture', () => {
  test('is in the middle if straight ahead, and right or up accordingly', () => {
    expect(seen([0, 0, -1])).toMatchObject({ x: 0, y: 0 });
    expect(seen([0.1, 0.2, -1])).toMatchObject({ x: expect.closeTo(0.1 / (Math.tan(0.5) * (4 / 3)), 5) });
    expect(seen([0.1, 0.2, -1])?.y).toBeCloseTo(0.2 / Math.tan(0.5), 5);
    expect(seen([0, 0, 1])).toBeUndefined();
    const turned: Quat = fromAxisAngle([0, 1, 0], 1);
    expect(seen(rotate(turned, [0, 0, -1]), { orientation: turned })?.x).toBeCloseTo(0, 6);
  });

  test('has the radiance illuminance divided by the pixel’s solid angle', () => {
    expect(seen([0, 0, -1])!.luminance * PIXEL).toBeCloseTo(1, 1);
  });

  // tan(θ′/2) = tan(θ/2)/[γ(1 + β)] (Penrose 1959).
  test('is aberrated by Penrose’s formula', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.01, max: 1.5, noNaN: true }),
        fc.double({ min: 0.3, max: 5, noNaN: true }),
        (theta, u) => {
          const place = seen([Math.sin(theta), 0, -Math.cos(theta)], { u: [0, 0, -u], lens: perspective(2) });
          const half = Math.tan(theta / 2) / (Math.sqrt(1 + u * u) + u);
          const expected = Math.tan(2 * Math.atan(half)) / (Math.tan(1) * (WIDTH / HEIGHT));
          if (expected < 1) expect(place?.x).toBeCloseTo(expected, 5);
        },
      ),
    );
  });

  // A blackbody of T·D in a solid angle that is D² times smaller.
  test('its light is multiplied by D⁴, of radiance, and D⁻², of solid angle', () => {
    const u = 1.2;
    const D = Math.sqrt(1 + u * u) + u;
    const moving = (settings: Partial<RenderSettings>) => seen([0, 0, -1], { u: [0, 0, -u] }, settings)!.luminance;
    const still = moving({ dopplerMix: 0, beaming: 0, aberration: false });
    expect(moving({ dopplerMix: 0, aberration: false }) / still).toBeCloseTo(D ** 4, 3);
    expect(moving({ dopplerMix: 0 }) / still).toBeCloseTo(D ** 2, 4);
    expect(seen([0, 0, -1], { u: [0, 0, -u] }, { view: 'galilean' })?.luminance).toBeCloseTo(
      seen([0, 0, -1])!.luminance,
    );
  });

  test('at the edge of a picture pixels have smaller solid angles', () => {
    const edge: Vec3 = scale([Math.tan(0.5), 0, -1], 1);
    const cosine = Math.cos(0.5);
    expect(seen(edge)!.luminance * cosine ** 3).toBeCloseTo(seen([0, 0, -1])!.luminance, -1);
  });
});
