import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dome, lambert, lit, look, SPECTRAL, twoSided } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { IDENTITY } from '../../math/quat.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { dispersedIndex } from '../../physics/optics/dispersion.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { box, plane, sphere } from '../../scene/mesh/primitives.ts';
import type { DistantLight, Material } from '../../scene/types.ts';

const options = { bounces: 0, mirrors: true, glass: false };
const glass = (given: Partial<Material>): Material =>
  makeMaterial({ name: 'glass', baseColor: [1, 1, 1], roughness: 0, transmission: { factor: 1 }, ...given });
const volume = { thickness: 1, attenuationColor: [1, 1, 1], attenuationDistance: Number.POSITIVE_INFINITY } as const;
const down: Vec3 = [0, 0, -1];

describe('a thin sheet', () => {
  it('lets light pass straight, tinted by its base colour, but for what it reflects', () => {
    const sheet = { mesh: twoSided(plane(40, 40)), material: glass({ baseColor: [0.5, 0.25, 1] }) };
    const wall = {
      mesh: plane(40, 40),
      material: lambert(0, { emissive: [1, 1, 1] }),
      motion: { kind: 'static', pose: { position: [0, 0, -3], orientation: IDENTITY } },
    } as const;
    const seen = look(lit([sheet, wall]), { position: [0, 0, 2] }, down, options);
    expect(seen).toEqual([0.5, 0.25, 1].map((x) => expect.closeTo(0.96 * x, 9)));
  });

  it('is a mirror and a window at once: nothing is lost under a uniform sky, rough or smooth', () => {
    for (const roughness of [0, 0.4]) {
      const scene = lit([{ mesh: twoSided(plane(400, 400)), material: glass({ roughness }) }], [dome([0.5, 0.5, 0.5])]);
      expect(look(scene, { position: [0, 0, 2] }, normalize([1, 0, -1]), options, 64)[0]).toBeCloseTo(0.5, 2);
    }
  });
});

describe('the inside of a body', () => {
  it('absorbs by Beer and Lambert’s law, and refracts by Snell’s', () => {
    const depth = 2;
    const slab = {
      mesh: box([60, 60, depth]),
      material: glass({
        ior: 1.5,
        volume: { thickness: depth, attenuationColor: [0.5, 0.25, 0.9], attenuationDistance: 1.5 },
      }),
    };
    const sky = lit([slab], [dome([1, 1, 1])]);
    fc.assert(
      fc.property(uniform(0, 1.2), (angle) => {
        const toward: Vec3 = [Math.sin(angle), 0, -Math.cos(angle)];
        const inside = depth / Math.sqrt(1 - (Math.sin(angle) / 1.5) ** 2);
        const T = 0.5 ** (inside / 1.5);
        // Fresnel's formulas at both sides, and the light that is reflected to and fro between them.
        const [c, g] = [Math.cos(angle), Math.sqrt(1.5 ** 2 - Math.sin(angle) ** 2)];
        const R = (((c - g) / (c + g)) ** 2 + ((2.25 * c - g) / (2.25 * c + g)) ** 2) / 2;
        const expected = R + ((1 - R) ** 2 * T) / (1 - R * T);
        const [r] = look(sky, { position: [0, 0, 4] }, toward, options, 256);
        expect(Math.abs(r - expected)).toBeLessThan(0.02);
      }),
      { numRuns: 8 },
    );
  });

  it('is as long in its rest frame when it flies: the absorption of a moving slab is that of one at rest, seen in its frame', () => {
    const material = glass({
      ior: 1,
      volume: { thickness: 2, attenuationColor: [0.5, 0.5, 0.5], attenuationDistance: 2 },
    });
    // Authored at rest: 2 m long along the motion, contracted in the world.
    const v = 0.8;
    const motion = {
      kind: 'uniform',
      pose: { position: [0, 0, 0], orientation: IDENTITY },
      velocity: [0, 0, v],
    } as const;
    const wall = {
      mesh: plane(900, 900),
      material: lambert(0, { emissive: [1, 1, 1] }),
      motion: { kind: 'static', pose: { position: [0, 0, -200], orientation: IDENTITY } },
    } as const;
    const scene = lit([{ mesh: box([600, 600, 2]), material, motion, authoredIn: 'rest' }, wall]);
    expect(look(scene, { position: [0, 0, 30], t: 10 }, down, options, 4)[0]).toBeCloseTo(0.5, 6);
  });

  it('is invisible under a uniform sky if it absorbs nothing, whatever its shape', () => {
    const scene = lit(
      [{ mesh: sphere(1, { segments: 24 }), material: glass({ volume, dispersion: 0.5 }) }],
      [dome([0.5, 0.5, 0.5])],
    );
    const [r] = look(scene, { position: [0, 0, 5] }, normalize([0.1, 0.05, -1]), options, 16);
    expect(r).toBeCloseTo(0.5, 6);
  });
});

describe('dispersion', () => {
  it('has the index n_d at 587.6 nm and the Abbe number 20/dispersion', () => {
    fc.assert(
      fc.property(uniform(1.3, 2.5), uniform(0.1, 1), (n, dispersion) => {
        const [F, d, C] = [486.1e-9, 587.6e-9, 656.3e-9].map((l) => dispersedIndex(n, dispersion, l));
        expect(d).toBeCloseTo(n, 12);
        expect((d - 1) / (F - C)).toBeCloseTo(20 / dispersion, 9);
      }),
    );
  });

  it('spreads the edge of what is seen through a prism: blue is bent most', () => {
    // A slab tilted against a bright half-plane: what is seen is shifted by d sin(θ − θ′)/cos θ′, more for higher n.
    const tilt = 1;
    const slab = {
      mesh: box([60, 60, 6]),
      material: glass({ ior: 1.5, dispersion: 4, volume }),
      motion: {
        kind: 'static',
        pose: { position: [0, 0, 0], orientation: [0, Math.sin(tilt / 2), 0, Math.cos(tilt / 2)] },
      },
    } as const;
    const shiftOf = (n: number): number => {
      const inner = Math.asin(Math.sin(tilt) / n);
      return (6 * Math.sin(tilt - inner)) / Math.cos(inner);
    };
    const [red, blue] = [650e-9, 450e-9].map((l) => shiftOf(dispersedIndex(1.5, 4, l)));
    const edge = (red + blue) / 2;
    const at = (x: number): Vec3 => {
      const half = {
        mesh: plane(40, 80),
        material: lambert(0, { emissive: [1, 1, 1] }),
        motion: { kind: 'static', pose: { position: [x + 20, 0, -30], orientation: IDENTITY } },
      } as const;
      return look(lit([slab, half]), { position: [0, 0, 30] }, down, options, 256, { settings: SPECTRAL });
    };
    // The bright half begins between where red and where blue arrive, on one side or the other.
    const seen = [at(edge), at(-edge)].sort((a, b) => Math.abs(b[0] - b[2]) - Math.abs(a[0] - a[2]))[0];
    expect(blue).toBeGreaterThan(red);
    expect(Math.abs(seen[0] - seen[2])).toBeGreaterThan(0.4);
  });
});

it('shadows of glass have its colour, and the absorption of the way inside', () => {
  const sun: DistantLight = {
    kind: 'distant',
    path: '/sun',
    direction: [0, 0, -1],
    color: [Math.PI, Math.PI, Math.PI],
  };
  const floor = {
    mesh: plane(20, 20),
    material: lambert(1),
    motion: { kind: 'static', pose: { position: [0, 0, -5], orientation: IDENTITY } },
  } as const;
  const block = {
    mesh: box([4, 4, 2]),
    material: glass({
      baseColor: [0.5, 1, 1],
      volume: { thickness: 2, attenuationColor: [1, 0.5, 1], attenuationDistance: 1 },
    }),
  };
  // From under the block's edge, so that the eye does not look through it.
  const eye = { position: [0, 6, -4] } as const;
  const toward = normalize([0, -6, -1]);
  const [lit1, shaded] = [lit([floor], [sun]), lit([floor, block], [sun])].map((s) => look(s, eye, toward, options));
  const passed = shaded.map((x, k) => x / lit1[k]);
  expect(passed).toEqual([0.5, 0.25, 1].map((x) => expect.closeTo(0.96 ** 2 * x, 4)));
});
