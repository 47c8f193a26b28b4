import { describe, expect, it } from 'vitest';
import { dot, length, type Vec3 } from '../../src/math/vec3.ts';
import { velocity } from '../../src/physics/lorentz/boost.ts';
import type { Material } from '../../src/scene/types.ts';
import { LUMINANCE_WEIGHTS, observedColor } from '../../src/spectrum/color/observerColor.ts';
import { VISIBLE } from '../../src/spectrum/observer/standardObserver.ts';
import { MATERIAL_PRESETS } from '../../src/spectrum/reflectance/materialPresets.ts';
import { filterFromRgb, WHITE_FILTER } from '../../src/spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, type LightSpectrum } from '../../src/spectrum/sources/lightSpectrum.ts';
import { openExample, topOfFlight } from './open.ts';

const scene = await openExample('sunset');
const beta = length(velocity(topOfFlight(scene).u));
/** The Doppler factor straight ahead. */
const D = Math.sqrt((1 + beta) / (1 - beta));

const material = (name: string): Material => scene.materials.find((m) => m.name.endsWith(name))!;
const sun = scene.lights.find(({ kind }) => kind === 'distant')!;
const sunlight: LightSpectrum = 'spectrum' in sun && sun.spectrum ? sun.spectrum : DAYLIGHT;

const color = ({ baseColor, uv, ir }: Material, d: number): Vec3 =>
  observedColor(filterFromRgb(baseColor, uv, ir), WHITE_FILTER, sunlight, 1, d);
const brightness = (m: Material, d: number): number => dot(LUMINANCE_WEIGHTS, color(m, d));
const [leaf, asphalt] = ['leaf', 'asphalt'].map(material);

describe('sunset street', () => {
  it('is traversed at 0.8 c, where only infrared is seen straight ahead', () => {
    expect(beta).toBeCloseTo(0.82, 1);
    expect(D).toBeGreaterThan(VISIBLE[1] / VISIBLE[0]);
  });

  it('has measured reflectances of leaves and asphalt, read back from the file', () => {
    for (const [m, name] of [
      [leaf, 'leaf'],
      [asphalt, 'asphalt'],
    ] as const) {
      const { uv, ir } = MATERIAL_PRESETS.get(name)!.filter;
      expect([m.uv, m.ir]).toEqual([uv, ir]);
    }
  });

  it('shows leaves brighter than asphalt by the ratio of their infrared reflectances', () => {
    const [a, b] = [color(leaf, D), color(asphalt, D)];
    for (const k of [0, 1, 2]) expect(a[k] / b[k]).toBeCloseTo(0.48 / 0.17, 6);
    expect(brightness(leaf, 1) / brightness(asphalt, 1)).toBeLessThan(2);
  });

  it('has trees darker than every wall at rest, and about as bright as the walls ahead', () => {
    const walls = scene.materials.filter(({ name }) => name.endsWith('_side'));
    const mean = (d: number) => walls.reduce((sum, wall) => sum + brightness(wall, d), 0) / walls.length;
    expect(walls.length).toBeGreaterThan(10);
    expect(brightness(leaf, 1) / mean(1)).toBeLessThan(0.6);
    expect(brightness(leaf, D) / mean(D)).toBeGreaterThan(0.9);
    expect(brightness(asphalt, D) / mean(D)).toBeLessThan(0.5);
  });

  // A blackbody of T seen with D looks like one of T·D.
  it('shows yellow windows and a red sun white, and the sky blue', () => {
    const window = material('window');
    expect(window.emissionTemperature).toBe(2200);
    expect(2200 * Math.round(D)).toBe(6600);
    for (const light of [{ kind: 'thermal', temperature: 2200 } as const, sunlight]) {
      const [r0, , b0] = observedColor(WHITE_FILTER, WHITE_FILTER, light, 1, 1);
      const [r, , b] = observedColor(WHITE_FILTER, WHITE_FILTER, light, 1, D);
      expect(b0 / r0).toBeLessThan(0.2);
      expect(b / r).toBeGreaterThan(0.8);
      expect(b / r).toBeLessThan(1.6);
    }
    const [r, , b] = observedColor(WHITE_FILTER, WHITE_FILTER, DAYLIGHT, 1, D);
    expect(b / r).toBeGreaterThan(1.8);
  });
});
