import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DIRECT, dome, lambert, lit, look, mirror, SPECTRAL, twoSided } from '../../../tests/support/lightKit.ts';
import { direction, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY } from '../../math/quat.ts';
import { add, dot, length, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { box, plane } from '../../scene/mesh/primitives.ts';
import type { DistantLight, Material } from '../../scene/types.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { filterOfReflectance } from '../../spectrum/color/filterOfReflectance.ts';
import { lightFilter } from '../../spectrum/color/lightFilter.ts';
import { colorOfSpectrum, observedColor } from '../../spectrum/color/observerColor.ts';
import { spectrumOfColor } from '../../spectrum/color/spectrumOfColor.ts';
import { filterFromRgb, WHITE_FILTER } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import { logLuminance } from '../../spectrum/sources/planck.ts';
import { sourceSpectrumOf } from './sourceSpectrum.ts';
import { RADIANCE_POWER } from './spectralContext.ts';
import { spectralSensor } from './spectralSensor.ts';

const settings = SPECTRAL;

/** Compares colours relative to the largest component; invisible light is black. */
function expectColor(seen: Vec3, expected: Vec3, tolerance: number): void {
  expect(length(sub(seen, expected))).toBeLessThanOrEqual(tolerance * Math.max(...expected.map(Math.abs)));
}

/** The colour of daylight of radiance 1, shifted by D: D⁵ B(Dλ, T) = B(λ, DT). */
const shiftedDaylight = (D: number): Vec3 =>
  scale(
    colorOfSpectrum({ kind: 'thermal', temperature: 6504 * D }),
    Math.exp(logLuminance(6504 * D) - logLuminance(6504)),
  );

/** D of light from n′, in the observer's frame, from a world at rest: 1/[γ(1 − β·n′)]. */
const dopplerOf = (u: Vec3, n: Vec3): number => 1 / (Math.sqrt(1 + dot(u, u)) - dot(u, n));

const shine = (emissive: Vec3): Material => lambert(0, { emissive });
const color = fc.tuple(uniform(0, 1), uniform(0, 1), uniform(0.05, 1));

describe('a closed box that emits white daylight', () => {
  const scene = lit([{ mesh: twoSided(box([4, 3, 5])), material: shine([1, 1, 1]) }]);
  const inside = { position: [0.3, -0.7, 1.1] } as const;

  it('is a blackbody of D · 6504 K for a moving observer', () => {
    fc.assert(
      fc.property(direction, properVelocityUpTo(3), (n, u) => {
        const seen = look(scene, { ...inside, u }, n, DIRECT, 16, { settings });
        expectColor(seen, shiftedDaylight(dopplerOf(u, n)), 3e-3);
      }),
      { numRuns: 60 },
    );
  });

  it('with partial effects: wavelengths by D^m, brightness by D^(4b)', () => {
    const shares = fc.tuple(uniform(0, 1), uniform(0, 1));
    fc.assert(
      fc.property(direction, properVelocityUpTo(3), shares, (n, u, [dopplerMix, beaming]) => {
        const D = dopplerOf(u, n);
        const seen = look(scene, { ...inside, u }, n, DIRECT, 16, { settings: { ...settings, dopplerMix, beaming } });
        const turned = observedColor(WHITE_FILTER, WHITE_FILTER, DAYLIGHT, 1, D ** dopplerMix);
        expectColor(seen, scale(turned, D ** (4 * beaming)), 3e-3);
      }),
      { numRuns: 60 },
    );
  });
});

describe('a sensor', () => {
  it.each([16, 64])('sums, over all combs of %d wavelengths, to the integral', (count) => {
    const combs = Array.from({ length: 4096 / count }, (_, k) =>
      spectralSensor(settings, count, ((k + 0.5) * count) / 4096),
    );
    fc.assert(
      fc.property(color, uniform(0.3, 3), (albedo, D) => {
        const shine = sourceSpectrumOf([1, 1, 1]);
        const seen = combs.map((eye) => {
          const there = eye.context.shifted(D);
          return eye.color(
            eye.context.received(there.filtered(there.emitted(shine), filterFromRgb(albedo)), D, RADIANCE_POWER),
          );
        });
        const mean = scale(seen.reduce(add), 1 / combs.length);
        expectColor(mean, scale(observedColor(filterFromRgb(albedo), WHITE_FILTER, DAYLIGHT, 1, D), D ** 4), 1e-4);
      }),
      { numRuns: 30 },
    );
  });
});

describe('at rest in white light', () => {
  it('a surface has its linear sRGB colour', () => {
    fc.assert(
      fc.property(color, fc.integer({ min: 0, max: 1e6 }), (albedo, seed) => {
        const scene = lit([{ mesh: plane(9, 9), material: { ...lambert(0), baseColor: albedo } }], [dome([1, 1, 1])]);
        const options = { ...DIRECT, bounces: 1 };
        const seen = (samples: number) =>
          look(scene, { position: [0, 0, 2] }, [0, 0, -1], options, samples, { settings, seed });
        expectColor(seen(1), albedo, 5e-3);
        expectColor(seen(16), albedo, 3e-3);
      }),
      { numRuns: 60 },
    );
  });

  it('colour noise is small even with one sample: for pure red, green and blue', () => {
    const spread = (albedo: Vec3, samples: number): number => {
      const scene = lit([{ mesh: plane(9, 9), material: shine(albedo) }]);
      const errors = Array.from({ length: 50 }, (_, seed) =>
        length(sub(look(scene, { position: [0, 0, 2] }, [0, 0, -1], DIRECT, samples, { settings, seed }), albedo)),
      );
      return Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length);
    };
    for (const albedo of [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 1, 1],
    ] as const) {
      expect(spread(albedo, 1)).toBeLessThan(0.004);
      expect(spread(albedo, 4)).toBeLessThan(0.012);
      expect(spread(albedo, 16)).toBeLessThan(0.0015);
      expect(spread(albedo, 64)).toBeLessThan(0.0004);
    }
  });
});

/** A floor that moves along x in its own plane, seen by an observer at rest: ν cos θ of a wave is invariant, so cos θ′ = cos θ/D_in. */
describe('a moving floor under a sun at rest', () => {
  const toward: Vec3 = normalize([-0.3, 0.5, -1]);
  function seenFloor(
    v: number,
    material: Material,
    s: Vec3,
    sun: Partial<DistantLight>,
    given: Partial<RenderSettings> = {},
  ) {
    const pose = { position: [0, 0, 0], orientation: IDENTITY } as const;
    const scene = lit(
      [{ mesh: plane(1e4, 1e4), material, motion: { kind: 'uniform', pose, velocity: [v, 0, 0] } }],
      [{ kind: 'distant', path: '/sun', direction: scale(s, -1), color: [1, 1, 1], ...sun }],
    );
    return look(scene, { position: [0, 0, 2] }, toward, DIRECT, 16, { settings: { ...settings, ...given } });
  }
  const factors = (v: number, s: Vec3) => {
    const gamma = 1 / Math.sqrt(1 - v * v);
    const [Din, Dout] = [gamma * (1 + v * s[0]), 1 / (gamma * (1 + v * toward[0]))];
    return { Din, Dout, brightness: (Dout ** 4 * Din * s[2]) / Math.PI };
  };
  const sunward = fc.tuple(uniform(-1, 1), uniform(-1, 1), uniform(0.2, 1)).map((s) => normalize(s));
  const speed = uniform(-0.8, 0.8);

  it('has the colour of its reflectance, shifted once, times the light, shifted twice', () => {
    fc.assert(
      fc.property(speed, sunward, color, color, (v, s, albedo, light) => {
        const { Din, Dout, brightness } = factors(v, s);
        const seen = seenFloor(v, { ...lambert(0), baseColor: albedo }, s, { color: light });
        const spectrum = spectrumOfColor(light);
        const exact = observedColor(filterFromRgb(albedo), lightFilter(light, spectrum), spectrum, Din, Dout);
        expectColor(seen, scale(exact, brightness), 4e-3);
      }),
      { numRuns: 60 },
    );
  });

  it('with a measured reflectance has the colour of the sum over every nanometre', () => {
    // The red edge of a leaf, which the band coefficients cannot represent.
    const values = Array.from({ length: 101 }, (_, i) => 0.04 + 0.44 / (1 + Math.exp((715 - (300 + 10 * i)) / 12)));
    const reflectance = { first: 300e-9, step: 10e-9, values };
    for (const v of [-0.5, -0.2, 0, 0.3]) {
      const s = normalize([0.3, 0.2, 1]);
      const { Din, Dout, brightness } = factors(v, s);
      const seen = seenFloor(v, { ...lambert(0), baseColor: filterOfReflectance(reflectance).rgb, reflectance }, s, {});
      expectColor(
        seen,
        scale(observedColor(filterOfReflectance(reflectance), WHITE_FILTER, DAYLIGHT, Din, Dout), brightness),
        4e-3,
      );
    }
  });

  it('with partial effects: applied to each of the two shifts', () => {
    const [v, s, dopplerMix, beaming] = [0.6, normalize([0.5, 0.2, 1]), 0.4, 0.7];
    const { Din, Dout } = factors(v, s);
    const exact = observedColor(
      filterFromRgb([0.9, 0.3, 0.1]),
      WHITE_FILTER,
      DAYLIGHT,
      Din ** dopplerMix,
      Dout ** dopplerMix,
    );
    const seen = seenFloor(v, { ...lambert(0), baseColor: [0.9, 0.3, 0.1] }, s, {}, { dopplerMix, beaming });
    const brightness = (Dout ** (4 * beaming) * Din ** (2 * beaming) * s[2]) / Din / Math.PI;
    expectColor(seen, scale(exact, brightness), 4e-3);
  });

  it.each<[string, LightSpectrum]>([
    [
      'a sodium lamp',
      {
        kind: 'lines',
        lines: [
          { wavelength: 589e-9, weight: 2 },
          { wavelength: 589.6e-9, weight: 1 },
        ],
      },
    ],
    [
      'hydrogen',
      {
        kind: 'lines',
        lines: [
          { wavelength: 656.3e-9, weight: 1 },
          { wavelength: 486.1e-9, weight: 0.4 },
        ],
      },
    ],
  ])('lines are seen at their exact shifted wavelengths: %s', (_, spectrum) => {
    fc.assert(
      fc.property(uniform(-0.3, 0.3), sunward, color, (v, s, albedo) => {
        const { Din, Dout, brightness } = factors(v, s);
        const seen = seenFloor(v, { ...lambert(0), baseColor: albedo }, s, { spectrum });
        const exact = observedColor(filterFromRgb(albedo), WHITE_FILTER, spectrum, Din, Dout);
        expectColor(seen, scale(exact, brightness), 1e-9);
      }),
      { numRuns: 60 },
    );
  });

  it.each([2000, 12000])('a light of %d K stays a blackbody', (temperature) => {
    const spectrum = { kind: 'thermal', temperature } as const;
    fc.assert(
      fc.property(speed, sunward, (v, s) => {
        const { Din, Dout, brightness } = factors(v, s);
        const D = Din * Dout;
        const white = colorOfSpectrum({ kind: 'thermal', temperature: temperature * D });
        const gain = Math.exp(logLuminance(temperature * D) - logLuminance(temperature)) / D ** 4;
        const seen = seenFloor(v, lambert(0.5), s, { spectrum, color: colorOfSpectrum(spectrum) });
        expectColor(seen, scale(white, 0.5 * gain * brightness), 4e-3);
      }),
      { numRuns: 40 },
    );
  });
});

describe('mirrors', () => {
  const wall = (x: number, angle: number, v: Vec3, material: Material) => ({
    mesh: plane(1e5, 1e5),
    material,
    motion: {
      kind: 'uniform',
      pose: { position: [x, 0, 0], orientation: fromAxisAngle([0, 1, 0], angle) },
      velocity: v,
    } as const,
  });

  it.each([0.3, -0.2])(
    'light reflected n times between an emissive mirror and one moving at %d c is shifted by [(1 − v)/(1 + v)]ⁿ, and I_ν/ν³ is invariant',
    (v) => {
      const glowing = mirror({ emissive: [1, 1, 1] });
      const scene = lit([wall(5, -Math.PI / 2, [v, 0, 0], mirror()), wall(-3, Math.PI / 2, [0, 0, 0], glowing)]);
      const seen = look(scene, { position: [0, 0, 0] }, [1, 0, 0], { ...DIRECT, mirrors: true }, 16, { settings });
      const once = (1 - v) / (1 + v);
      // Eight reflections deep: four of them at the emissive mirror.
      const expected = [1, 2, 3, 4].map((n) => shiftedDaylight(once ** n));
      expectColor(seen, [0, 1, 2].map((k) => expected.reduce((sum, rgb) => sum + rgb[k], 0)) as unknown as Vec3, 3e-3);
    },
  );

  it('one that moves in its own plane preserves colours exactly: D = 1 for both ways together', () => {
    const things = (v: number) =>
      lit([wall(5, -Math.PI / 2, [0, v, 0], mirror()), wall(-3, Math.PI / 2, [0, 0, 0], shine([0.2, 0.5, 0.9]))]);
    const seen = (v: number) =>
      look(things(v), { position: [0, 0, 0] }, normalize([1, 0.4, 0.2]), { ...DIRECT, mirrors: true }, 1, { settings });
    expectColor(seen(0.8), seen(0), 1e-9);
  });
});
