import { describe, expect, it } from 'vitest';
import { MIN_LOBE_ROUGHNESS, specularLobe } from './specularLobe.ts';

/** ∫ f cos θ dΩ of GGX with F = (1 − V·H)^power, by even steps over the hemisphere. */
function albedo(NV: number, roughness: number, power: 0 | 5): number {
  const a2 = roughness ** 4;
  const smith = (x: number): number => Math.sqrt(x * x * (1 - a2) + a2);
  const [vx, steps] = [Math.sqrt(1 - NV * NV), 400];
  let sum = 0;
  for (let i = 0; i < steps; i++)
    for (let j = 0; j < steps; j++) {
      const [z, phi] = [(i + 0.5) / steps, (Math.PI * (j + 0.5)) / steps];
      const level = Math.sqrt(1 - z * z);
      const [hx, hy, hz] = [vx + level * Math.cos(phi), level * Math.sin(phi), NV + z];
      const length = Math.hypot(hx, hy, hz);
      const [NH, VH] = [hz / length, (vx * hx + NV * hz) / length];
      const distribution = a2 / (Math.PI * (NH * NH * (a2 - 1) + 1) ** 2);
      sum += ((distribution * 0.5 * z) / (z * smith(NV) + NV * smith(z))) * (1 - VH) ** power;
    }
  return (sum * 2 * Math.PI) / (steps * steps);
}

describe('the share of uniform light that GGX reflects', () => {
  it.each([
    [1, 1],
    [0.5, 1],
    [0.1, 0.83],
    [0.97, 0.5],
    [0.31, 0.5],
    [0.7, 0.37],
    [0.2, 0.37],
  ])('at N·V = %d and roughness %d is its integral', (NV, roughness) => {
    const { scale, bias } = specularLobe(NV, roughness);
    expect(Math.abs(scale + bias - albedo(NV, roughness, 0))).toBeLessThan(0.004);
    expect(Math.abs(bias - albedo(NV, roughness, 5))).toBeLessThan(0.004);
  });

  it('at full roughness, seen from above, is 1 − ln 2', () => {
    const { scale, bias } = specularLobe(1, 1);
    expect(scale + bias).toBeCloseTo(1 - Math.log(2), 2);
  });

  it('is all of it for a smooth surface', () => {
    const { scale, bias, cosine } = specularLobe(0.6, MIN_LOBE_ROUGHNESS);
    expect(scale + bias).toBeCloseTo(1, 3);
    expect(cosine).toBeCloseTo(0.6, 2);
  });
});
