import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DIRECT, dome, GREY, lambert, lamp, lit, look, mirror, twoSided } from '../../../tests/support/lightKit.ts';
import { direction, properVelocityUpTo, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { random } from '../../math/random.ts';
import { dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { box, grid, plane, sphere } from '../../scene/mesh/primitives.ts';
import { dopplerTint } from '../../spectrum/doppler/dopplerTint.ts';

/** D of light from n′, in the observer's frame, from a world at rest: 1/[γ(1 − β·n′)]. */
const dopplerOf = (u: Vec3, n: Vec3): number => 1 / (Math.sqrt(1 + dot(u, u)) - dot(u, n));

describe('a closed, uniformly emissive box', () => {
  const glowing = (albedo: number) => {
    const material = lambert(albedo, { emissive: [0.25, 0.5, 0.75] });
    return lit([{ mesh: twoSided(box([4, 3, 5])), material }]);
  };
  const inside = { position: [0.3, -0.7, 1.1] } as const;

  it('is uniform for an observer at rest: E (1 + ρ + … + ρⁿ)', () => {
    fc.assert(
      fc.property(direction, uniform(0, 1), fc.integer({ min: 0, max: 5 }), (n, albedo, bounces) => {
        const [r, g, b] = look(glowing(albedo), inside, n, { ...DIRECT, bounces });
        const gain = Array.from({ length: bounces + 1 }, (_, k) => albedo ** k).reduce((a, x) => a + x, 0);
        expect(r).toBeCloseTo(0.25 * gain, 12);
        expect(g).toBeCloseTo(0.5 * gain, 12);
        expect(b).toBeCloseTo(0.75 * gain, 12);
      }),
      { numRuns: 60 },
    );
  });

  it('is D⁴ times as bright for a moving one, in Doppler-shifted colours', () => {
    const scene = glowing(0);
    fc.assert(
      fc.property(direction, properVelocityUpTo(20), (n, u) => {
        const D = dopplerOf(u, n);
        const gray = look(scene, { ...inside, u }, n);
        expect(gray[1] / (0.5 * D ** 4)).toBeCloseTo(1, 9);
        const settings = { ...GREY, dopplerMix: 0.5, beaming: 0.25 };
        const colored = look(scene, { ...inside, u }, n, DIRECT, 1, { settings });
        const expected = scale(dopplerTint([0.25, 0.5, 0.75], D, 0.5), D);
        expect(length([colored[0] - expected[0], colored[1] - expected[1], colored[2] - expected[2]])).toBeLessThan(
          1e-9 * length(expected),
        );
      }),
      { numRuns: 60 },
    );
  });

  it('is the same in the views without light, at any speed', () => {
    for (const view of ['simultaneity', 'galilean'] as const) {
      const seen = look(glowing(0), { ...inside, u: [2, 0, 1] }, [0, 0.6, 0.8], DIRECT, 1, {
        settings: { ...GREY, view },
      });
      expect(seen).toEqual([0.25, 0.5, 0.75]);
    }
  });
});

describe('the white furnace test: a lossless reflector is invisible under a uniform sky', () => {
  const options = { bounces: 1, mirrors: true, glass: false };
  const sky = dome([0.5, 0.75, 0.25]);

  it.each([
    ['a white ball', lambert(1)],
    ['a mirror ball', mirror()],
  ])('%s, also with few vertices and for a moving observer', (_, material) => {
    const scene = lit([{ mesh: sphere(1, { segments: 10 }), material }], [sky]);
    fc.assert(
      fc.property(uniform(-0.9, 0.9), uniform(-0.9, 0.9), fc.constantFrom(0, 3), (x, y, speed) => {
        const n = normalize([x, y, -5]);
        const eye = { position: [0, 0, 5], u: [0, 0, speed] } as const;
        const D = dopplerOf(eye.u, n);
        for (const [k, value] of look(scene, eye, n, options).entries())
          expect(value / (sky.color[k] * D ** 4)).toBeCloseTo(1, 9);
      }),
      { numRuns: 60 },
    );
  });

  it.each([0.2, 0.5, 1])('a white metal of roughness %d, in its middle and near its rim', (roughness) => {
    const scene = lit([{ mesh: sphere(1, { segments: 96, rings: 48 }), material: mirror({ roughness }) }], [sky]);
    for (const x of [0, 0.5, 0.8]) {
      const [r] = look(scene, { position: [x, 0, 5] }, [0, 0, -1], options, 1024);
      expect(Math.abs(r / sky.color[0] - 1)).toBeLessThan(0.01);
    }
  });
});

describe('a sheet above a floor', () => {
  /** A black sheet of 2a × 2a at height h hides F = (4/π) (a/√(a²+h²)) atan(a/√(a²+h²)) of the sky from the floor below its centre (Siegel & Howell, C-11, four corners). */
  const [a, h] = [1.5, 0.8];
  const slope = a / Math.hypot(a, h);
  const hidden = (4 / Math.PI) * slope * Math.atan(slope);
  const scene = lit(
    [
      { mesh: plane(50, 50), material: lambert(0.5) },
      {
        mesh: plane(2 * a, 2 * a),
        material: lambert(0),
        motion: { kind: 'static', pose: { position: [0, 0, h], orientation: fromAxisAngle([1, 0, 0], Math.PI) } },
      },
    ],
    [dome([1, 1, 1])],
  );
  const eye = { position: [0, 0, 0.4] } as const;
  const options = { bounces: 1, mirrors: false, glass: false };

  it('leaves the sky light that passes it', () => {
    const [r] = look(scene, eye, [0, 0, -1], options, 4096);
    // Independent random numbers would be off by 0.003.
    expect(Math.abs(r - 0.5 * (1 - hidden))).toBeLessThan(0.0015);
  });

  it('the error falls as 1/√N with independent random numbers, faster with the pixel’s sequence; the same seed gives the same bits', () => {
    const spread = (samples: number) => {
      const errors = Array.from({ length: 60 }, (_, seed) => {
        const numbers = random(seed + 1);
        const plain = Array.from(
          { length: samples },
          () => look(scene, eye, [0, 0, -1], options, 1, { seed: Math.floor(numbers() * 2 ** 31) })[0],
        );
        return plain.reduce((sum, x) => sum + x, 0) / samples - 0.5 * (1 - hidden);
      });
      return Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length);
    };
    const [few, many] = [spread(4), spread(64)];
    expect(few / many).toBeGreaterThan(3);
    expect(few / many).toBeLessThan(5.3);
    const sequence = (seed: number) => look(scene, eye, [0, 0, -1], options, 64, { seed })[0];
    const errors = Array.from({ length: 60 }, (_, seed) => sequence(seed) - 0.5 * (1 - hidden));
    expect(Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / 60)).toBeLessThan(0.6 * many);
    expect(sequence(5)).toBe(sequence(5));
  });
});

describe('a closed box', () => {
  it('is dark inside, curved or not, also where its normals point to the wrong side', () => {
    const options = { bounces: 2, mirrors: true, glass: false };
    for (const shape of [box([2, 2, 2]), sphere(1, { segments: 12 })])
      for (const sign of [1, -1]) {
        const mesh = { ...twoSided(shape), normals: shape.normals.map((x) => sign * x) };
        const scene = lit([{ mesh, material: lambert(0.8) }], [dome([1, 1, 1]), lamp([0, 0, 3])]);
        const eye = { position: [0, 0.1, 0] } as const;
        for (const n of [normalize([0.3, 0.2, 1]), normalize([1, -0.4, 0.2])])
          expect(look(scene, eye, n, options, 64)).toEqual([0, 0, 0]);
      }
  });
});

describe('transparent and cut-out surfaces', () => {
  const floor = { mesh: plane(9, 9), material: lambert(1) } as const;
  const sheet = (material: Parameters<typeof lit>[0][number]['material']) => ({
    mesh: twoSided(grid(9, 9, 2, 2)),
    material,
    motion: { kind: 'static', pose: { position: [0, 0, 1], orientation: fromAxisAngle([0, 0, 1], 0.3) } } as const,
  });
  const light = lamp([0, 0, 3], { color: [Math.PI, Math.PI, Math.PI] });
  const down = (scene: ReturnType<typeof lit>, z: number) => look(scene, { position: [0.2, 0.1, z] }, [0, 0, -1])[0];

  it('transmit light, and are blended over what is behind', () => {
    const clear = lambert(0, { opacity: 0.25, emissive: [1, 1, 1] });
    const scene = lit([floor, sheet(clear)], [light]);
    const bare = down(lit([floor], [light]), 0.5);
    expect(down(scene, 0.5)).toBeCloseTo(0.75 * bare, 12);
    expect(down(scene, 2)).toBeCloseTo(0.25 + 0.75 * 0.75 * bare, 12);
  });

  it('are absent below the opacity threshold, and opaque above it', () => {
    const bare = down(lit([floor], [light]), 0.5);
    const cut = (opacity: number) => lit([floor, sheet(lambert(0, { opacity, opacityThreshold: 0.5 }))], [light]);
    expect(down(cut(0.4), 0.5)).toBeCloseTo(bare, 12);
    expect(down(cut(0.4), 2)).toBeCloseTo(bare, 12);
    expect(down(cut(0.6), 0.5)).toBe(0);
    expect(down(cut(0.6), 2)).toBe(0);
  });
});
