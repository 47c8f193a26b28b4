import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { lambert, lamp, lit, look, mirror, SPECTRAL, twoSided } from '../../../tests/support/lightKit.ts';
import { direction, properVelocityUpTo } from '../../../tests/support/physicsArbitraries.ts';
import { conjugate, fromAxisAngle, multiply, type Quat } from '../../math/quat.ts';
import { addScaled, distance, length, normalize, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { inverseBoost, velocity } from '../../physics/lorentz/boost.ts';
import { addVelocities, wignerRotation } from '../../physics/lorentz/velocity.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { box, plane, sphere } from '../../scene/mesh/primitives.ts';
import type { Material, Mesh, UniformMotion } from '../../scene/types.ts';
import type { LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';

/**
 * Converts a body to the world frame: in the frame that moves with u it is at `position` at time 0 and has the proper velocity w (0: at rest);
 * c = 1 m/s. Its own axes are reached by two boosts, in the world by one: they differ by the Wigner rotation.
 */
function carried(position: Vec3, orientation: Quat, u: Vec3, w = ZERO): UniformMotion {
  const [t, ...x] = inverseBoost([0, ...position], u);
  const v = velocity(addVelocities(u, w));
  const turned = multiply(conjugate(wignerRotation(u, w)), orientation);
  return { kind: 'uniform', pose: { position: addScaled(x, v, -t), orientation: turned }, velocity: v };
}

const TURN = fromAxisAngle([1, 2, 3], 0.8);
const NOT: Quat = [0, 0, 0, 1];
const things: readonly (readonly [Mesh, Material, Vec3, Quat])[] = [
  [plane(40, 40), lambert(0.5, { ior: 1.5, roughness: 0.4 }), [0, 0, -1], NOT],
  [box([1, 1, 1]), makeMaterial({ name: 'red', baseColor: [0.8, 0.2, 0.1], roughness: 0.2 }), [1.5, 0, 0], TURN],
  [sphere(0.6, { segments: 12 }), mirror({ roughness: 0.3 }), [-1, 0.5, 0], NOT],
  [
    sphere(0.5, { segments: 12 }),
    makeMaterial({ name: 'glass', opacity: 0.1, roughness: 0, ior: 1.4 }),
    [0.2, -1.2, 0.2],
    NOT,
  ],
  [twoSided(box([9, 9, 9])), lambert(0.3, { emissive: [0.2, 0.3, 0.4] }), [0, 0, 3], NOT],
];

const MERCURY: LightSpectrum = {
  kind: 'lines',
  lines: [435.8, 546.1, 577].map((nm) => ({ wavelength: nm * 1e-9, weight: 1 })),
};

/** Objects and a light at rest in the frame of u, and a mirror and two point lights that move in it. */
const stage = (u: Vec3) =>
  lit(
    [
      ...things.map(([mesh, material, position, orientation]) => ({
        mesh,
        material,
        motion: carried(position, orientation, u),
        authoredIn: 'rest' as const,
      })),
      {
        mesh: sphere(0.4, { segments: 12 }),
        material: mirror(),
        motion: carried([0.4, 1.3, 0], TURN, u, [0.7, -0.4, 0.2]),
        authoredIn: 'rest',
      },
    ],
    [
      lamp(ZERO, { motion: carried([1, 1, 3], NOT, u), radius: 0.4, color: [5, 4, 3] }),
      lamp(ZERO, { motion: carried([-2, 0, 2], NOT, u, [0.3, 1.5, -0.2]), color: [2, 3, 4] }),
      lamp(ZERO, { motion: carried([2, -1, 2], NOT, u, [-0.2, 0.1, 0.1]), color: [2, 2, 2], spectrum: MERCURY }),
    ],
  );

describe('light transport is independent of the frame of description', () => {
  it('a scene with its lights and observer looks the same at any common velocity', () => {
    const options = { bounces: 2, mirrors: true, glass: true };
    const rest = stage(ZERO);
    const [t, position] = [0.7, [0.3, -0.2, 2.5] as const];
    const cases = fc.sample(fc.tuple(properVelocityUpTo(5), direction), 150);
    const errors = cases.map(([u, [x, y, z]], seed) => {
      const n = normalize([x, y, z - 0.8]);
      const [time, ...place] = inverseBoost([t, ...position], u);
      const at = look(rest, { t, position }, n, options, 1, { seed, settings: SPECTRAL });
      const flying = look(stage(u), { t: time, position: place, u }, n, options, 1, { seed, settings: SPECTRAL });
      return distance(flying, at) / Math.max(length(at), 1e-3);
    });
    errors.sort((a, b) => a - b);
    // Curved mirrors and glass amplify small differences within a few reflections: some paths end at another object.
    expect(errors[75]).toBeLessThan(1e-9);
    expect(errors[142]).toBeLessThan(1e-4);
  });

  it('but an observer moving relative to the objects sees other light', () => {
    const still = look(stage(ZERO), { position: [0, 0, 2] }, [0, 0, -1]);
    expect(look(stage(scale([1, 0, 0], 0.5)), { position: [0, 0, 2] }, [0, 0, -1])).not.toEqual(still);
  });
});
