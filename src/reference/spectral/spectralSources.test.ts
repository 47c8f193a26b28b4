import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DIRECT, dome, lambert, lamp, lit, look, SPECTRAL } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { dot, length, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { box, plane } from '../../scene/mesh/primitives.ts';
import type { Light, Material } from '../../scene/types.ts';
import { colorOfSpectrum, LUMINANCE_WEIGHTS, observedColor } from '../../spectrum/color/observerColor.ts';
import { filterFromRgb, WHITE_FILTER } from '../../spectrum/reflectance/spectralFilter.ts';
import { LIGHT_PRESETS } from '../../spectrum/sources/lightPresets.ts';
import { DAYLIGHT, type LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';

/** The colour seen straight down (the floor) or up (the sky), moving towards it with γβ = w: D = e^rapidity. */
function seen(things: readonly Material[], lights: readonly Light[], w: number, toward: 1 | -1, bounces = 0): Vec3 {
  const scene = lit(
    things.map((material) => ({ mesh: plane(1e4, 1e4), material })),
    lights,
  );
  const eye = { position: [0, 0, 2], u: [0, 0, toward * w] } as const;
  return look(scene, eye, [0, 0, toward], { ...DIRECT, bounces }, 64, { settings: SPECTRAL });
}
const shiftOf = (w: number): number => w + Math.hypot(1, w);

function expectColor(found: Vec3, expected: Vec3, tolerance: number): void {
  expect(length(sub(found, expected))).toBeLessThanOrEqual(tolerance * Math.max(...expected.map(Math.abs)));
}
const speed = uniform(-2, 2);
const color = fc.tuple(uniform(0.05, 1), uniform(0.05, 1), uniform(0.05, 1));

describe('light that is invisible at rest', () => {
  const leaf = (given: Partial<Material>) =>
    makeMaterial({ name: 'leaf', baseColor: [0.05, 0.2, 0.03], ior: 1, ...given });
  const sky = dome([1, 1, 1]);

  it('is not seen at rest', () => {
    expect(seen([leaf({ uv: 0.7, ir: 0.9 })], [sky], 0, -1, 1)).toEqual(seen([leaf({})], [sky], 0, -1, 1));
  });

  it('only infrared is seen from D = 830/360 on, and only ultraviolet up to D = 360/830', () => {
    for (const [w, share] of [
      [1.5, 0.9],
      [-1.5, 0.7],
    ]) {
      const D = shiftOf(w);
      const expected = scale(observedColor(WHITE_FILTER, WHITE_FILTER, DAYLIGHT, 1, D), share * D ** 4);
      expectColor(seen([leaf({ uv: 0.7, ir: 0.9 })], [sky], w, -1, 1), expected, 1e-3);
    }
  });

  it('in between a part of each is seen: N ∫ cmf ρ(Dλ) D⁵ S(Dλ) dλ', () => {
    fc.assert(
      fc.property(speed, color, uniform(0, 1), uniform(0, 1), (w, rgb, uv, ir) => {
        const D = shiftOf(w);
        const expected = scale(observedColor(filterFromRgb(rgb, uv, ir), WHITE_FILTER, DAYLIGHT, 1, D), D ** 4);
        const white = scale(observedColor(WHITE_FILTER, WHITE_FILTER, DAYLIGHT, 1, D), D ** 4);
        const found = seen([leaf({ baseColor: rgb, uv, ir })], [sky], w, -1, 1);
        expect(length(sub(found, expected))).toBeLessThan(4e-3 * Math.max(...white));
      }),
      { numRuns: 30 },
    );
  });
});

describe('emissive surfaces', () => {
  it('with a temperature have the luminance of their colour, and are blackbodies in motion', () => {
    fc.assert(
      fc.property(speed, uniform(1500, 9000), color, (w, temperature, emissive) => {
        const D = shiftOf(w);
        const embers = lambert(0, { emissive, emissionTemperature: temperature });
        const light = observedColor(WHITE_FILTER, WHITE_FILTER, { kind: 'thermal', temperature }, 1, D);
        expectColor(seen([embers], [], w, -1), scale(light, dot(LUMINANCE_WEIGHTS, emissive) * D ** 4), 3e-3);
      }),
      { numRuns: 30 },
    );
  });

  it('with a colour emit daylight behind a filter', () => {
    fc.assert(
      fc.property(speed, color, (w, emissive) => {
        const D = shiftOf(w);
        const expected = scale(observedColor(WHITE_FILTER, filterFromRgb(emissive), DAYLIGHT, 1, D), D ** 4);
        expectColor(seen([lambert(0, { emissive })], [], w, -1), expected, 4e-3);
      }),
      { numRuns: 30 },
    );
  });
});

describe('the sky', () => {
  const lamps = ['daylight', 'candle', 'fluorescent', 'triphosphor', 'led', 'mercury', 'hydrogen'];
  it.each(lamps)('has the spectrum of its dome: %s', (name) => {
    const spectrum = LIGHT_PRESETS.get(name)?.spectrum as LightSpectrum;
    for (const w of [-0.3, 0, 0.4]) {
      const D = shiftOf(w);
      const sky = { ...dome(scale(colorOfSpectrum(spectrum), 0.5)), spectrum };
      expectColor(
        seen([], [sky], w, 1),
        scale(observedColor(WHITE_FILTER, WHITE_FILTER, spectrum, 1, D), 0.5 * D ** 4),
        5e-3,
      );
    }
  });

  it('shows the discs of distant lights in their own spectra', () => {
    const spectrum: LightSpectrum = { kind: 'lines', lines: [{ wavelength: 546.1e-9, weight: 1 }] };
    const sun = { kind: 'distant', path: '/sun', direction: [0, 0, -1], color: [2, 2, 2], spectrum } as const;
    const D = shiftOf(0.1);
    const expected = scale(observedColor(WHITE_FILTER, WHITE_FILTER, spectrum, 1, D), 2 * 20.3 * D ** 4);
    expectColor(seen([], [sun], 0.1, 1), expected, 1e-9);
  });
});

describe('lights', () => {
  it('of several spectra light a coloured floor that moves away from them', () => {
    const albedo = filterFromRgb([0.8, 0.4, 0.1]);
    for (const name of ['sodium', 'mercury', 'tungsten', 'led']) {
      const spectrum = LIGHT_PRESETS.get(name)?.spectrum as LightSpectrum;
      // The light's position in the floor's frame affects only its brightness; the colour follows from the two shifts.
      const v = 0.25;
      const scene = lit(
        [
          {
            mesh: box([9, 9, 1]),
            material: lambert(0, { baseColor: albedo.rgb }),
            motion: {
              kind: 'uniform',
              pose: { position: [0, 0, -9], orientation: [0, 0, 0, 1] },
              velocity: [0, 0, -v],
            },
          },
        ],
        [lamp([0, 0, 0.5], { spectrum, color: colorOfSpectrum(spectrum) })],
      );
      const found = look(scene, { position: ZERO }, [0, 0, -1], DIRECT, 64, { settings: SPECTRAL });
      const D = Math.sqrt((1 - v) / (1 + v));
      expectColor(normalize(found), normalize(observedColor(albedo, WHITE_FILTER, spectrum, D, D)), 5e-3);
    }
  });
});
