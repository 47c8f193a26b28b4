import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { dome, lit, look } from '../../../tests/support/lightKit.ts';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { add, dot, normalize, type Vec3 } from '../../math/vec3.ts';
import { thinFilmReflectance } from '../../physics/optics/thinFilm.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { plane } from '../../scene/mesh/primitives.ts';
import type { Material } from '../../scene/types.ts';
import { filterFromRgb, reflectanceAt } from '../../spectrum/reflectance/spectralFilter.ts';
import { brdfOf, evaluateBrdf } from './brdf.ts';
import type { SurfacePoint } from './surface.ts';

const N: Vec3 = [0, 0, 1];
const above = fc
  .tuple(uniform(0.3, 0.99), uniform(0, 2 * Math.PI))
  .map(([z, phi]): Vec3 => [Math.sqrt(1 - z * z) * Math.cos(phi), Math.sqrt(1 - z * z) * Math.sin(phi), z]);

const point = (given: Partial<SurfacePoint>): SurfacePoint => ({
  albedo: [0.5, 0.5, 0.5],
  filter: filterFromRgb([0.5, 0.5, 0.5]),
  opacity: 1,
  emissive: [0, 0, 0],
  roughness: 0.5,
  metallic: 0,
  occlusion: 1,
  ior: 1.5,
  normal: N,
  uv: [0, 0],
  ...given,
});

const red = (given: Partial<SurfacePoint>, V: Vec3, L: Vec3): number =>
  evaluateBrdf(brdfOf(point(given), V), L)?.rgb[0] ?? 0;

/** Trowbridge–Reitz, Smith's correlated visibility and Schlick's term, as the Khronos sample viewer has them (brdf.glsl). */
function khronosGgx(a: number, V: Vec3, L: Vec3): { readonly DV: number; readonly grazing: number } {
  const H = normalize(add(V, L));
  const f = (H[2] * a * a - H[2]) * H[2] + 1;
  const D = (a * a) / (Math.PI * f * f);
  const [v, l] = [V[2], L[2]];
  const smith = l * Math.sqrt(v * v * (1 - a * a) + a * a) + v * Math.sqrt(l * l * (1 - a * a) + a * a);
  return { DV: (D * 0.5) / smith, grazing: (1 - dot(V, H)) ** 5 };
}

const mirrored = { bounces: 0, mirrors: true, glass: false };

/** The light of a surface under a uniform sky of radiance 0.5, seen at an angle. */
const inFurnace = (material: Partial<Material>, cosine: number, samples: number): number => {
  const scene = lit(
    [{ mesh: plane(400, 400), material: makeMaterial({ name: 'm', ...material }) }],
    [dome([0.5, 0.5, 0.5])],
  );
  const toward: Vec3 = [Math.sqrt(1 - cosine ** 2), 0, -cosine];
  return look(scene, { position: [0, 0, 2] }, toward, mirrored, samples)[0];
};

describe('a varnish', () => {
  it('adds its own GGX lobe, and dims what is below by its Fresnel reflectance', () => {
    fc.assert(
      fc.property(above, above, uniform(0, 1), uniform(0.06, 0.2), (V, L, factor, roughness) => {
        const bare = red({}, V, L);
        const coated = red({ clearcoat: { factor, roughness, normal: N } }, V, L);
        const { DV, grazing } = khronosGgx(roughness ** 2, V, L);
        const glint = factor * (0.04 + 0.96 * grazing) * DV * L[2];
        const fresnel = factor * (0.04 + 0.96 * (1 - V[2]) ** 5);
        // A rough lobe reflects a little less than Fresnel's share of a smooth one at grazing angles, which the base keeps.
        const tolerance = 0.003 * glint + 0.08 * fresnel * bare + 1e-6;
        expect(Math.abs(coated - (bare * (1 - fresnel) + glint))).toBeLessThan(tolerance);
      }),
    );
  });

  it('keeps the energy of a lossless surface, however rough both are, as its angle changes', () => {
    for (const [roughness, coat] of [
      [0, 0],
      [0.5, 0],
      [0, 0.6],
      [0.4, 0.4],
    ])
      for (const cosine of [0.9, 0.3]) {
        const clearcoat = { factor: 1, roughness: coat };
        const light = inFurnace({ baseColor: [1, 1, 1], metallic: 1, roughness, clearcoat }, cosine, 2048);
        expect(Math.abs(light - 0.5)).toBeLessThan(0.012);
      }
  });

  it('reflects in its own normal: 4 % of a lamp in the mirrored direction', () => {
    const tilted = normalize([0.3, 0, 1]);
    const V: Vec3 = [0, 0, 1];
    const L = normalize([2 * tilted[0] * tilted[2], 0, 2 * tilted[2] ** 2 - 1]);
    const peak = red({ clearcoat: { factor: 1, roughness: 0.1, normal: tilted } }, V, L) - red({}, V, L);
    const off = red({ clearcoat: { factor: 1, roughness: 0.1, normal: N } }, V, L) - red({}, V, L);
    // 0.04 D/(4 N·V), D = 1/(π a²).
    expect(peak).toBeCloseTo(0.04 / (Math.PI * 1e-4) / (4 * tilted[2]), 1);
    expect(Math.abs(off)).toBeLessThan(0.05);
  });
});

describe('the strength and colour of reflection', () => {
  it('are F₀ = min(0.04 colour, 1) factor and F₉₀ = factor', () => {
    fc.assert(
      fc.property(above, above, uniform(0, 1), uniform(0, 30), (V, L, factor, colour) => {
        const given = { filter: filterFromRgb([0, 0, 0]), roughness: 0.1 };
        const { DV, grazing } = khronosGgx(0.01, V, L);
        const F0 = Math.min(0.04 * colour, 1) * factor;
        const expected = (F0 + (factor - F0) * grazing) * DV * L[2];
        const got = red({ ...given, specular: { factor, color: [colour, 1, 1] } }, V, L);
        // Roughness 0.1 scatters a little of it between its microfacets, more than once.
        expect(Math.abs(got - expected)).toBeLessThan(0.02 * expected + 1e-9);
      }),
    );
  });

  it('leave metals as they are', () => {
    const [V, L] = [normalize([0.3, 0.1, 1]), normalize([-0.4, 0, 1])];
    const metal = red({ metallic: 1 }, V, L);
    expect(red({ metallic: 1, specular: { factor: 0, color: [0, 0, 0] } }, V, L)).toBeCloseTo(metal, 12);
  });
});

describe('grooves', () => {
  /** D V of KHR_materials_anisotropy, with T = (cos φ, sin φ, 0). */
  function grooved(roughness: number, strength: number, phi: number, V: Vec3, L: Vec3): number {
    const [b, H] = [roughness ** 2, normalize(add(V, L))];
    const a = b + (1 - b) * strength ** 2;
    const [T, B]: Vec3[] = [
      [Math.cos(phi), Math.sin(phi), 0],
      [-Math.sin(phi), Math.cos(phi), 0],
    ];
    const [x, y, z] = [b * dot(T, H), a * dot(B, H), a * b * H[2]];
    const w = (a * b) / (x * x + y * y + z * z);
    const shadow = (one: Vec3, other: Vec3): number => other[2] * Math.hypot(a * dot(T, one), b * dot(B, one), one[2]);
    return ((a * b * w * w) / Math.PI) * (0.5 / (shadow(V, L) + shadow(L, V)));
  }

  it('widen the reflection along their direction', () => {
    const along = (phi: number): Vec3 => [Math.cos(phi), Math.sin(phi), 0];
    fc.assert(
      fc.property(above, above, uniform(0, 7), uniform(0.15, 0.4), uniform(0, 1), (V, L, phi, roughness, strength) => {
        const black = { filter: filterFromRgb([0, 0, 0]), roughness };
        const got = red({ ...black, grooves: { along: along(phi), strength } }, V, L);
        const grazing = (1 - dot(V, normalize(add(V, L)))) ** 5;
        const expected = (0.04 + 0.96 * grazing) * grooved(roughness, strength, phi, V, L) * L[2];
        // What is scattered several times adds F₀ (1 − E)/E.
        expect(got).toBeGreaterThan(expected * (1 - 1e-9));
        expect(got).toBeLessThan(expected * 1.04 + 1e-12);
      }),
    );
  });

  it('keep the energy of a lossless surface', () => {
    for (const [roughness, strength, rotation, cosine] of [
      [0.05, 1, 0, 0.8],
      [0.2, 0.8, Math.PI / 2, 0.3],
      [0.2, 0.8, 0, 0.3],
    ]) {
      const metal = { baseColor: [1, 1, 1] as const, metallic: 1, roughness };
      const light = inFurnace({ ...metal, anisotropy: { strength, rotation } }, cosine, 1024);
      expect(Math.abs(light - 0.5)).toBeLessThan(0.01);
    }
  });
});

describe('fuzz', () => {
  /** D and V of KHR_materials_sheen, written from its text: Charlie's distribution, and Estevez and Kulla's shadowing. */
  function charlie(roughness: number, V: Vec3, L: Vec3): number {
    const alpha = roughness ** 2;
    const H = normalize(add(V, L));
    const D = ((2 + 1 / alpha) * Math.sqrt(1 - H[2] ** 2) ** (1 / alpha)) / (2 * Math.PI);
    const s = (1 - alpha) ** 2;
    const fitted = (x: number): number => {
      const [a, b, c] = [
        25.3245 * s + 21.5473 * (1 - s),
        3.32435 * s + 3.82987 * (1 - s),
        0.16801 * s + 0.19823 * (1 - s),
      ];
      return a / (1 + b * x ** c) - (1.27393 * s + 1.9776 * (1 - s)) * x - (4.85967 * s + 4.32054 * (1 - s));
    };
    const lambda = (x: number): number => Math.exp(x < 0.5 ? fitted(x) : 2 * fitted(0.5) - fitted(1 - x));
    return D / ((1 + lambda(V[2]) + lambda(L[2])) * 4 * V[2] * L[2]);
  }

  /** ∫ D V N·L dΩ by a grid of its own. */
  function albedo(roughness: number, V: Vec3): number {
    let sum = 0;
    const [rings, turns] = [150, 90];
    for (let i = 0; i < rings; i++)
      for (let j = 0; j < turns; j++) {
        const [NL, phi] = [((i + 0.5) / rings) ** 2, (2 * Math.PI * (j + 0.5)) / turns];
        const flat = Math.sqrt(1 - NL * NL);
        const ring = (2 * Math.sqrt(NL) * 2 * Math.PI) / (rings * turns);
        sum += charlie(roughness, V, [flat * Math.cos(phi), flat * Math.sin(phi), NL]) * NL * ring;
      }
    return sum;
  }

  it('adds its fibres, and dims what is below by what they reflect of uniform light', () => {
    for (const roughness of [0.25, 0.5, 1])
      for (const z of [0.2, 0.5, 0.9]) {
        const V: Vec3 = [Math.sqrt(1 - z * z), 0, z];
        const share = albedo(roughness, V);
        for (const L of [normalize([-0.9, 0.3, 0.2]), normalize([0.2, 0.4, 1])]) {
          const [bare, fuzzy] = [{}, { sheen: { color: [0.6, 0.8, 0.1] as const, roughness } }].map((m) =>
            red(m, V, L),
          );
          const expected = bare * (1 - 0.8 * share) + 0.6 * charlie(roughness, V, L) * L[2];
          expect(Math.abs(fuzzy - expected)).toBeLessThan(0.01 * expected);
        }
      }
  });

  it('of white on a lossless surface reflects all light, and never more, at all angles', () => {
    for (const [roughness, cosine] of [
      [0.07, 0.05],
      [0.2, 0.1],
      [0.5, 0.3],
      [1, 0.8],
    ]) {
      const sheen = { color: [1, 1, 1] as const, roughness };
      const light = inFurnace({ baseColor: [1, 1, 1], metallic: 1, roughness: 0, sheen }, cosine, 1024);
      expect(Math.abs(light - 0.5)).toBeLessThan(0.02);
    }
  });

  it('is seen through a varnish', () => {
    const V = normalize([0.8, 0, 0.6]);
    const L = normalize([-0.7, 0.2, 0.5]);
    const clearcoat = { factor: 1, roughness: 0.05, normal: N };
    const given = { filter: filterFromRgb([0, 0, 0]), ior: 1 };
    const [coat, both] = [{}, { sheen: { color: [1, 1, 1] as const, roughness: 0.6 } }].map((m) =>
      red({ ...given, ...m, clearcoat }, V, L),
    );
    const passed = 1 - (0.04 + 0.96 * (1 - V[2]) ** 5);
    expect((both - coat) / (charlie(0.6, V, L) * L[2])).toBeCloseTo(passed, 2);
  });
});

it('a film shows the reflectance of its interference at each wavelength of the rest frame', () => {
  const [V, L] = [normalize([0.5, 0.1, 1]), normalize([-0.4, 0, 1])];
  const film = { factor: 1, ior: 1.33, thickness: 400e-9 };
  const { DV } = khronosGgx(0.01, V, L);
  const VH = dot(V, normalize(add(V, L)));
  const given = { filter: filterFromRgb([0, 0, 0]), roughness: 0.1, film };
  const seen = evaluateBrdf(brdfOf(point(given), V), L)!;
  for (const wavelength of [320e-9, 450e-9, 550e-9, 650e-9, 1000e-9]) {
    const expected = thinFilmReflectance(VH, 1.33, 1.5, 400e-9, wavelength) * DV * L[2];
    expect(Math.abs(reflectanceAt(seen, wavelength) - expected)).toBeLessThan(0.01 * DV * 0.04);
  }
});
