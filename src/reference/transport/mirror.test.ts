import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dome, lambert, lit, look, mirror, picture } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { box, plane, sphere } from '../../scene/mesh/primitives.ts';

const options = { bounces: 0, mirrors: true, glass: false };

/** A sky whose red encodes the angle from the zenith, in thirds of π/256, and whose green is 1. */
const ENCODED_SKY = {
  ...dome([1, 1, 1]),
  texture: picture(Array.from({ length: 256 }, (_, row) => [row, 255, 0] as const)),
};
/** sin of the height above the horizon, decoded from the linear ramp between row centres, and D. */
function read([red, green]: Vec3): { sine: number; D: number } {
  const row = (255 * red) / green;
  return { sine: Math.cos(((row + 0.5) / 256) * Math.PI), D: green ** (1 / 4) };
}

describe('a moving mirror (Einstein 1905, §8)', () => {
  it('reflects at cos φ‴ = −[(1 + β²) cos φ − 2β]/(1 − 2β cos φ + β²), ν‴ = ν (1 − 2β cos φ + β²)/(1 − β²)', () => {
    fc.assert(
      fc.property(uniform(-0.9, 0.9), uniform(0.02, 0.98), fc.boolean(), (beta, share, up) => {
        // Light moves along (cos φ, sin φ) towards +x, faster along x than the mirror: cos φ > β.
        const cos = beta + (1 - beta) * share;
        const sin = Math.sqrt(1 - cos * cos) * (up ? 1 : -1);
        const scene = lit(
          [
            {
              mesh: plane(1e4, 1e4),
              material: mirror(),
              motion: {
                kind: 'uniform',
                pose: { position: [3, 0, 0], orientation: fromAxisAngle([0, 1, 0], -Math.PI / 2) },
                velocity: [beta, 0, 0],
              },
            },
          ],
          [ENCODED_SKY],
        );
        const denominator = 1 - 2 * beta * cos + beta * beta;
        const back = -((1 + beta * beta) * cos - 2 * beta) / denominator;
        const shift = denominator / (1 - beta * beta);
        // k_y is invariant: ν sin φ = ν‴ sin φ‴.
        const toward = normalize([-back, -sin / shift, 0]);
        const { sine, D } = read(look(scene, { position: [0, 0, 0] }, toward, options));
        expect(D / shift).toBeCloseTo(1, 9);
        expect(sine).toBeCloseTo(-sin, 2);
        expect(Math.abs(Math.asin(sine) + Math.asin(sin))).toBeLessThan(1e-3 + 0.01 * Math.abs(sin));
      }),
      { numRuns: 100 },
    );
  });
});

describe('mirrors', () => {
  it('show lit surfaces and other mirrors', () => {
    const glow = { mesh: sphere(0.5, { segments: 12 }), material: lambert(0, { emissive: [0.25, 0.5, 1] }) };
    const wall = (x: number, angle: number) => ({
      mesh: plane(9, 9),
      material: mirror(),
      motion: { kind: 'static', pose: { position: [x, 0, 0], orientation: fromAxisAngle([0, 1, 0], angle) } } as const,
    });
    const left = wall(-2, Math.PI / 2);
    const right = wall(2, -Math.PI / 2);
    const far = {
      ...glow,
      motion: { kind: 'static', pose: { position: [0.5, 0, 0], orientation: [0, 0, 0, 1] } },
    } as const;
    const scene = lit([left, right, far]);
    // Its images by one, two and three reflections, the last one always in the right mirror.
    for (const image of [4 - 0.5, 4 + 4 + 0.5, 8 + 4 - 0.5]) {
      const seen = look(scene, { position: [0.5, 0, 2.5] }, normalize([image - 0.5, 0, -2.5]), options);
      expect(
        seen.map((x) => +x.toFixed(9)),
        `${image}`,
      ).toEqual([0.25, 0.5, 1]);
    }
  });

  it('are dark with mirrors off, except for the sky and emissive surfaces', () => {
    const lit1 = lit([{ mesh: box([1, 1, 1]), material: mirror() }], [dome([1, 1, 1])]);
    const none = { bounces: 0, mirrors: false, glass: false };
    expect(look(lit1, { position: [0, 0, 5] }, [0, 0, -1], none)).toEqual([0, 0, 0]);
    expect(look(lit1, { position: [0, 0, 5] }, [0, 0, -1], { ...none, bounces: 1 })).toEqual([1, 1, 1]);
  });
});
