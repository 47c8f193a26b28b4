import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dome, GREY, lambert, lit, look, picture, twoSided } from '../../../tests/support/lightKit.ts';
import { direction, uniform } from '../../../tests/support/physicsArbitraries.ts';
import { fromAxisAngle, IDENTITY } from '../../math/quat.ts';
import { addScaled, cross, dot, length, normalize, type Vec3 } from '../../math/vec3.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { box, plane, sphere } from '../../scene/mesh/primitives.ts';
import { createLightingContext } from '../lights/createLightingContext.ts';
import { rayBackInside } from '../lights/lightingContext.ts';
import { restFrame } from '../spectral/restFrame.ts';
import { dielectricFresnel, refracted } from './fresnel.ts';

const options = { bounces: 0, mirrors: false, glass: true };
const clear = (ior: number) => makeMaterial({ name: 'glass', opacity: 0, roughness: 0, ior });

describe('a surface between two media', () => {
  it('refracts by Snell’s law, in the plane of incidence', () => {
    fc.assert(
      fc.property(direction, direction, uniform(1.01, 3), (N, side, n) => {
        const d = normalize(addScaled(side, N, -dot(side, N) - 0.7));
        const t = refracted(d, N, 1 / n)!;
        expect(length(t)).toBeCloseTo(1, 12);
        expect(n * length(cross(t, N))).toBeCloseTo(length(cross(d, N)), 12);
        expect(dot(cross(t, N), cross(d, N))).toBeGreaterThanOrEqual(-1e-12);
        // The reverse path.
        const back = refracted(t, N, n)!;
        expect(length(addScaled(back, d, -1))).toBeLessThan(1e-9);
      }),
    );
  });

  it('reflects ((n − 1)/(n + 1))² at normal incidence, nothing p-polarised at Brewster’s angle, and all beyond the critical angle', () => {
    expect(dielectricFresnel(1, 1.5)).toBeCloseTo(0.04, 12);
    expect(dielectricFresnel(1, 1 / 1.5)).toBeCloseTo(0.04, 12);
    expect(dielectricFresnel(0, 1.5)).toBe(1);
    // tan θ_B = n: half of ((n² − 1)/(n² + 1))² remains.
    const n = 1.7;
    expect(dielectricFresnel(Math.cos(Math.atan(n)), n)).toBeCloseTo(((n * n - 1) / (n * n + 1)) ** 2 / 2, 12);
    const critical = Math.sqrt(1 - 1 / 1.5 ** 2);
    expect(refracted([Math.sqrt(1 - (critical - 1e-6) ** 2), 0, -(critical - 1e-6)], [0, 0, 1], 1.5)).toBeUndefined();
    expect(dielectricFresnel(critical - 1e-6, 1 / 1.5)).toBe(1);
    expect(dielectricFresnel(critical + 1e-3, 1 / 1.5)).toBeLessThan(0.9);
  });
});

describe('a block of glass', () => {
  const [depth, n] = [2, 1.5];
  const scene = lit([
    {
      mesh: box([40, 40, depth]),
      material: clear(n),
      motion: { kind: 'static', pose: { position: [0, 0, -depth / 2], orientation: IDENTITY } },
    },
    {
      // Red increases with v just below the block, from y = −8 to 8; green is constant.
      mesh: plane(16, 16),
      material: lambert(0, {
        emissive: [1, 1, 1],
        emissiveTexture: picture(Array.from({ length: 256 }, (_, row) => [255 - row, 255, 0] as const)),
      }),
      motion: { kind: 'static', pose: { position: [0, 0, -depth - 1e-6], orientation: IDENTITY } },
    },
  ]);
  const toward = (angle: number): Vec3 => [0, Math.sin(angle), -Math.cos(angle)];
  const eye = { position: [0, 0, 1] } as const;
  /** Where the bottom is seen from a height of 1 at an angle to the vertical [m along y]: from most of the light, which is transmitted directly. */
  function bottom(angle: number): number {
    const places = Array.from({ length: 15 }, (_, seed) => {
      const [red, green] = look(scene, eye, toward(angle), options, 1, { seed });
      return ((255 * (red / green) + 0.5) / 256 - 0.5) * 16;
    });
    return places.filter(Number.isFinite).sort((a, b) => a - b)[6];
  }

  it('raises the apparent bottom: d tan θ′ with sin θ = n sin θ′, near the vertical to the depth d/n', () => {
    for (const angle of [0, 0.1, 0.5, 1.2]) {
      const inside = Math.asin(Math.sin(angle) / n);
      expect(bottom(angle)).toBeCloseTo(Math.tan(angle) + depth * Math.tan(inside), 4);
    }
    const apparent = (bottom(0.02) - Math.tan(0.02)) / Math.tan(0.02);
    expect(apparent / (depth / n)).toBeCloseTo(1, 2);
  });

  it('attenuates light by the reflection of both sides', () => {
    // At normal incidence R is reflected at the top; of the rest 1/(1 + R) leaves through the bottom, directly or after internal reflections.
    const R = 0.04;
    const [, light] = look(scene, eye, toward(0), options, 1024);
    expect(Math.abs(light - (1 - R) / (1 + R))).toBeLessThan(0.003);
  });
});

describe('glass under a uniform sky', () => {
  it('is invisible, whatever its shape: light is either refracted or reflected', () => {
    const scene = lit([{ mesh: sphere(1, { segments: 24 }), material: clear(1.5) }], [dome([0.5, 0.5, 0.5])]);
    fc.assert(
      fc.property(uniform(-0.6, 0.6), uniform(-0.6, 0.6), (x, y) => {
        const [r] = look(scene, { position: [0, 0, 5] }, normalize([x / 3, y / 3, -1]), options, 4);
        expect(r).toBeCloseTo(0.5, 6);
      }),
      { numRuns: 30 },
    );
  });

  it('blends its own colour by its opacity', () => {
    const half = makeMaterial({ name: 'milk', opacity: 0.25, baseColor: [0, 0, 0], roughness: 0, ior: 1 });
    const scene = lit([{ mesh: box([2, 2, 2]), material: half }], [dome([0.5, 0.5, 0.5])]);
    expect(look(scene, { position: [0, 0, 5] }, [0, 0, -1], options)[0]).toBeCloseTo(0.75 * 0.5, 12);
  });
});

describe('moving glass', () => {
  it('drags light: (c/n + v)/(1 + v/nc), Fresnel’s v(1 − 1/n²) for slow glass', () => {
    const lighting = createLightingContext(lit([]), GREY, options, [0, 0, 0], () => 0);
    const speed = (v: number, n: number) => {
      const frame = restFrame([v / Math.sqrt(1 - v * v), 0, 0]);
      // The ray goes back along −x: the light itself moves towards +x, with the glass.
      const { dt, dx } = rayBackInside(lighting, { t: 0, x: [0, 0, 0], clearance: 0 }, [-1, 0, 0], frame, n);
      return dx[0] / dt;
    };
    fc.assert(
      fc.property(uniform(-0.99, 0.99), uniform(1, 3), (v, n) => {
        expect(speed(v, n)).toBeCloseTo((1 / n + v) / (1 + v / n), 12);
      }),
    );
    expect((speed(1e-6, 1.5) - 1 / 1.5) / 1e-6).toBeCloseTo(1 - 1 / 1.5 ** 2, 5);
  });

  it.each([0.6, 0, -0.2])('delays what is seen through it (v = %d c)', (v) => {
    const [n, far, thick] = [1.5, 10, 2];
    // Light of a sheet that exists from t = 0 on travels from x = far to 0; the block extends from 4 + vt to 4 + thick + vt.
    const block = {
      mesh: box([thick, 50, 50]),
      material: clear(n),
      motion: {
        kind: 'uniform',
        pose: { position: [4 + thick / 2, 0, 0], orientation: IDENTITY },
        velocity: [v, 0, 0],
      },
    } as const;
    const sheet = {
      mesh: twoSided(plane(50, 50)),
      material: lambert(0, { emissive: [1, 1, 1] }),
      motion: { kind: 'static', pose: { position: [far, 0, 0], orientation: fromAxisAngle([0, 1, 0], Math.PI / 2) } },
      lifetime: { birth: 0, death: Number.POSITIVE_INFINITY },
    } as const;
    const scene = lit([block, sheet]);
    const enters = (far - 4 - thick) / (1 + v);
    const slow = (1 / n - v) / (1 - v / n);
    const leaves = enters + thick / (slow + v);
    const arrives = leaves + 4 + v * leaves;
    const toward: Vec3 = [1, 0, 0];
    const seen = (t: number) => look(scene, { position: [0, 0, 0], t }, toward, options, 64)[0];
    expect(seen(arrives - 1e-6)).toBe(0);
    expect(seen(arrives + 1e-6)).toBeGreaterThan(0.7);
  });
});
