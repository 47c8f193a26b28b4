import { describe, expect, it } from 'vitest';
import { dot, normalize, type Vec3 } from '../../math/vec3.ts';
import { DAY_SKY } from './sceneLights.ts';
import { gradientAt, type SkyColors, skyIrradiance } from './skyGradient.ts';

const day: SkyColors = { zenith: DAY_SKY.color, ...DAY_SKY.gradient };

/** (1/π) ∫ L(n) max(n·N, 0) dΩ over cells of equal solid angle. */
function integral(sky: SkyColors, N: Vec3): number {
  const [rows, columns] = [400, 200];
  let sum = 0;
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const [h, phi] = [(2 * (j + 0.5)) / rows - 1, (2 * Math.PI * (i + 0.5)) / columns];
      const level = Math.sqrt(1 - h * h);
      const n: Vec3 = [level * Math.cos(phi), h, level * Math.sin(phi)];
      sum += gradientAt(h, sky)[1] * Math.max(dot(n, N), 0);
    }
  return (4 * sum) / (rows * columns);
}

describe('irradiance of a sky with a horizon', () => {
  it.each([1, 0.7, 0.3, 0, -0.4, -0.8, -1])('is its integral, for a normal at the height %d', (c) => {
    const { level, rise, bend } = skyIrradiance(day);
    const N = normalize([Math.sqrt(1 - c * c), c, 0]);
    expect(Math.abs(level[1] + rise[1] * c + bend[1] * c * c - integral(day, N))).toBeLessThan(0.012);
  });

  it('equals the sky where that is uniform except for the haze', () => {
    const even = skyIrradiance({ zenith: [1, 1, 1], horizon: [1, 1, 1], ground: [1, 1, 1] });
    expect(even.level[0] + even.rise[0] + even.bend[0]).toBeCloseTo(1, 2);
  });
});
