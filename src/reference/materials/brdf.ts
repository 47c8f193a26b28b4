import type { Random } from '../../math/random.ts';
import { add, addScaled, cross, dot, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { thinFilmReflectance } from '../../physics/optics/thinFilm.ts';
import { sheenLobe, sheenTerm } from '../../scene/materials/sheenLobe.ts';
import { MIN_LOBE_ROUGHNESS, specularLobe as reflectedLobe } from '../../scene/materials/specularLobe.ts';
import { mixFilters, multiplyFilters, neutralFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { filterFromRgb, reflectanceAt, type SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { cosineDirection, fromLocalBasis, orthonormalBasis, reflect } from '../sampling/directions.ts';
import { PRIMARIES } from '../spectral/rgbSensor.ts';
import type { SurfacePoint } from './surface.ts';

// Lambert and GGX with Schlick's Fresnel, all in the surface's rest frame; N, V, L unit, away from the surface.

/** The BRDF of a surface towards V. */
export interface Brdf {
  /** Albedo of the Lambert part. */
  readonly diffuse: SpectralFilter;
  /** Fresnel reflectance at normal and at grazing incidence. */
  readonly F0: SpectralFilter;
  readonly F90: number;
  /** For direct light; bounded from below, since the highlight of a point light on a perfect mirror has no size. */
  readonly roughness: number;
  /** Whether it reflects as a mirror when it is followed. */
  readonly smooth: boolean;
  /** (1 − E)/E, E the share of uniform light that single scattering would reflect of a surface with F = 1. */
  readonly lost: number;
  /** Its microfacets, if they have a direction. */
  readonly grooves?: Grooves;
  readonly N: Vec3;
  readonly V: Vec3;
  readonly NV: number;
  /** The share of light that passes the varnish and the fuzz over it; the diffuse part has it already. */
  readonly passed: number;
  /** A thin film over it, and F₀ of what is below it. */
  readonly film?: NonNullable<SurfacePoint['film']>;
  /** The fuzz over it. */
  readonly fuzz?: Fuzz;
  /** The varnish over it. */
  readonly coat?: Brdf;
}

/** Unit directions in the surface, along which the widths of the distribution of normals are `a` and `b`. */
interface Grooves {
  readonly T: Vec3;
  readonly B: Vec3;
  readonly a: number;
  readonly b: number;
}

/** Fibres over a surface: `color` is that of the light that they reflect, as far as the varnish lets it through. */
interface Fuzz {
  readonly color: SpectralFilter;
  readonly roughness: number;
  /** The share of light that passes them. */
  readonly passed: number;
}

export function brdfOf(point: SurfacePoint, V: Vec3): Brdf {
  const { filter, metallic, roughness, ior, specular, grooves, clearcoat, sheen, film, normal } = point;
  const dielectricF0 = ((ior - 1) / (ior + 1)) ** 2;
  const dielectric = specular ? specularF0(dielectricF0, specular) : neutralFilter(dielectricF0);
  const F0 = mixFilters(dielectric, 1 - metallic, filter, metallic);
  // At equal refractive indices nothing is reflected, not even at grazing incidence.
  const F90 = ior === 1 ? metallic : (specular?.factor ?? 1) * (1 - metallic) + metallic;
  const coat = clearcoat && coatOf(clearcoat, V);
  const varnished = coat ? 1 - uniformReflectance(coat) : 1;
  const fuzz = sheen && fuzzOf(sheen, Math.max(dot(normal, V), 1e-3), varnished);
  const passed = varnished * (fuzz?.passed ?? 1);
  const even = glossy(F0, F90, roughness, normal, V, passed);
  const base = grooves && grooves.strength > 0 ? grooved(even, grooves) : even;
  const diffuse = scaleFilter(filter, (1 - metallic) * passed);
  return { ...base, diffuse, ...(fuzz && { fuzz }), ...(coat && { coat }), ...(film && { film }) };
}

function fuzzOf({ color, roughness }: NonNullable<SurfacePoint['sheen']>, NV: number, varnished: number): Fuzz {
  const { share, gain } = sheenLobe(NV, roughness);
  const filter = scaleFilter(filterFromRgb(color), gain * varnished);
  return { color: filter, roughness, passed: 1 - Math.min(Math.max(...color), 1) * share };
}

/** F₀ of `SpecularReflection` (scene/materials/layers.ts). */
function specularF0(F0: number, { factor, color }: NonNullable<SurfacePoint['specular']>): SpectralFilter {
  const [r, g, b] = color.map((x) => Math.min(F0 * x, 1) * factor);
  return filterFromRgb([r, g, b]);
}

/** F₀ of a refractive index of 1.5. */
const COAT_F0 = 0.04;

const coatOf = ({ factor, roughness, normal }: NonNullable<SurfacePoint['clearcoat']>, V: Vec3): Brdf =>
  glossy(neutralFilter(COAT_F0 * factor), factor, roughness, normal, V, 1);

/** A surface without a diffuse part. */
function glossy(F0: SpectralFilter, F90: number, roughness: number, N: Vec3, V: Vec3, passed: number): Brdf {
  const NV = Math.max(dot(N, V), 1e-3);
  const lobe = reflectedLobe(NV, roughness);
  return {
    diffuse: neutralFilter(0),
    F0,
    F90,
    roughness: Math.min(Math.max(roughness, MIN_ROUGHNESS), 1),
    smooth: roughness < MIN_ROUGHNESS,
    lost: 1 / (lobe.scale + lobe.bias) - 1,
    N,
    V,
    NV,
    passed,
  };
}

/** The same with grooves: α widened along them (KHR_materials_anisotropy). */
function grooved(even: Brdf, { along: T, strength }: NonNullable<SurfacePoint['grooves']>): Brdf {
  const b = even.roughness ** 2;
  const grooves = { T, B: cross(even.N, T), a: b + (1 - b) * Math.min(strength, 1) ** 2, b };
  const brdf = { ...even, smooth: false, grooves };
  return { ...brdf, lost: 1 / reflectedShare(brdf) - 1 };
}

/** Steps of the integral over the visible normals. */
const SHARE_STEPS = { radius: 8, angle: 12 } as const;

/** The share of uniform light that single scattering reflects where F = 1: the mean of G₂/G₁ over the visible normals. */
function reflectedShare(brdf: Brdf): number {
  const { radius, angle } = SHARE_STEPS;
  let sum = 0;
  for (let i = 0; i < radius; i++)
    for (let j = 0; j < angle; j++) {
      const H = visibleNormal(brdf, (i + 0.5) / radius, (j + 0.5) / angle);
      sum += keptOf(brdf, reflect(scale(brdf.V, -1), H));
    }
  return Math.min(sum / (radius * angle), 1);
}

/** G₂/G₁ (Heitz 2014, eq. 99). */
function keptOf(brdf: Brdf, L: Vec3): number {
  const { N, V, NV } = brdf;
  const NL = dot(N, L);
  if (NL <= 0) return 0;
  const seen = smithTerm(brdf, V, NV);
  return (NL * (NV + seen)) / (NL * seen + NV * smithTerm(brdf, L, NL));
}

/** The reflectance of a varnish in uniform light, which the surface below does not get. */
function uniformReflectance({ F0, F90, NV, roughness, smooth, lost }: Brdf): number {
  const { scale: share, bias } = reflectedLobe(NV, roughness);
  const [f0] = F0.rgb;
  return smooth ? f0 + (F90 - f0) * (1 - NV) ** 5 : (f0 * share + F90 * bias) * (1 + f0 * lost);
}

/** BRDF · cos for light from L; undefined if L is below the horizon. */
export function evaluateBrdf(brdf: Brdf, L: Vec3): SpectralFilter | undefined {
  const base = evaluateLayer(brdf, L);
  const coat = brdf.coat && evaluateLayer(brdf.coat, L);
  const fuzz = brdf.fuzz && evaluateFuzz(brdf, brdf.fuzz, L);
  return plus(plus(base, fuzz), coat);
}

const plus = (a: SpectralFilter | undefined, b: SpectralFilter | undefined): SpectralFilter | undefined =>
  a && b ? mixFilters(a, 1, b, 1) : (a ?? b);

function evaluateFuzz({ N, V, NV }: Brdf, { color, roughness }: Fuzz, L: Vec3): SpectralFilter | undefined {
  const NL = Math.min(dot(N, L), 1);
  if (NL <= 0) return undefined;
  const NH = Math.min(dot(N, normalize(add(L, V))), 1);
  return scaleFilter(color, NL * sheenTerm(NL, NV, NH, roughness));
}

function evaluateLayer(brdf: Brdf, L: Vec3): SpectralFilter | undefined {
  const NL = Math.min(dot(brdf.N, L), 1);
  if (NL <= 0) return undefined;
  const { specular, F } = ggx(brdf, L, NL);
  return mixFilters(brdf.diffuse, NL / Math.PI, F, NL * specular);
}

/** Cook–Torrance with GGX and the height-correlated Smith term (Heitz 2014, eq. 99). */
function ggx(brdf: Brdf, L: Vec3, NL: number): { readonly specular: number; readonly F: SpectralFilter } {
  const { V, NV } = brdf;
  const H = normalize(add(L, V));
  const visibility = 0.5 / Math.max(NL * smithTerm(brdf, V, NV) + NV * smithTerm(brdf, L, NL), 1e-4);
  return {
    specular: Math.min(ggxDistribution(brdf, H) * visibility, 1e4),
    F: multiple(brdf, fresnel(brdf, dot(V, H))),
  };
}

/** √(a² + (1 − a²) x²) of the cosine x of a direction X to the normal; with grooves √((a X·T)² + (b X·B)² + x²). */
function smithTerm({ grooves, roughness }: Brdf, X: Vec3, x: number): number {
  if (grooves) return Math.sqrt((grooves.a * dot(grooves.T, X)) ** 2 + (grooves.b * dot(grooves.B, X)) ** 2 + x * x);
  const a2 = roughness ** 4;
  return Math.sqrt(x * x * (1 - a2) + a2);
}

/** Schlick 1994; of the light that passes what is above. */
function fresnel({ F0, F90, passed, film }: Brdf, VH: number): SpectralFilter {
  const grazing = (1 - Math.min(Math.max(VH, 0), 1)) ** 5;
  const bare = mixFilters(F0, (1 - grazing) * passed, neutralFilter(F90), grazing * passed);
  if (!film || film.factor === 0) return bare;
  return mixFilters(bare, 1 - film.factor, filmFilter(film, F0, VH), film.factor * passed);
}

/** The film's reflectance at every wavelength of the rest frame; that of the three primaries where there are no spectra. */
function filmFilter({ ior, thickness }: NonNullable<Brdf['film']>, F0: SpectralFilter, VH: number): SpectralFilter {
  const at = (wavelength: number): number =>
    thinFilmReflectance(VH, ior, indexOf(reflectanceAt(F0, wavelength)), thickness, wavelength);
  const [r, g, b] = PRIMARIES.map(at);
  const bands = filterFromRgb([r, g, b]);
  const rest = (wavelength: number, width?: number): number => at(wavelength) - reflectanceAt(bands, wavelength, width);
  return { ...bands, residual: { at: rest, share: 1 } };
}

/** The real refractive index of a reflectance at normal incidence. */
function indexOf(F0: number): number {
  const root = Math.sqrt(Math.min(Math.max(F0, 0), 0.9999));
  return (1 + root) / (1 - root);
}

/** With the light that is scattered several times between microfacets, so that a lossless surface loses none (Turquin 2019; docs/physics.md §6.7). */
const multiple = ({ F0, lost }: Brdf, F: SpectralFilter): SpectralFilter =>
  mixFilters(F, 1, multiplyFilters(F, F0), lost);

/** Surfaces of lower roughness reflect as perfectly smooth ones. */
const MIN_ROUGHNESS = MIN_LOBE_ROUGHNESS;

/** A part of the BRDF with its importance sampling. */
export interface Lobe {
  /** A random direction to light, with a density roughly proportional to BRDF · cos. */
  sample(random: Random): Vec3;
  /** Probability density of `sample` at L [1/sr]; absent if there is only one direction. */
  readonly pdf?: (L: Vec3) => number;
  /** BRDF · cos divided by the density, for light from L. */
  weight(L: Vec3): SpectralFilter;
}

export const diffuseLobe = ({ N, diffuse }: Brdf): Lobe => ({
  sample: (random) => cosineDirection(N, random),
  pdf: (L) => Math.max(dot(N, L), 0) / Math.PI,
  weight: () => diffuse,
});

/** All lobes but the diffuse one. */
export const glossyLobes = (brdf: Brdf): readonly Lobe[] => [
  specularLobe(brdf),
  ...(brdf.fuzz ? [fuzzLobe(brdf, brdf.fuzz)] : []),
  ...(brdf.coat ? [specularLobe(brdf.coat)] : []),
];

/** Uniform over the hemisphere, since fibres reflect towards grazing angles. */
const fuzzLobe = (brdf: Brdf, fuzz: Fuzz): Lobe => ({
  sample: (random) => {
    const [up, angle] = [random(), 2 * Math.PI * random()];
    const flat = Math.sqrt(1 - up * up);
    return fromLocalBasis(brdf.N, flat * Math.cos(angle), flat * Math.sin(angle), up);
  },
  pdf: (L) => (dot(brdf.N, L) > 0 ? 1 / (2 * Math.PI) : 0),
  weight: (L) => scaleFilter(evaluateFuzz(brdf, fuzz, L) ?? neutralFilter(0), 2 * Math.PI),
});

/** GGX. Samples the microfacet normals visible from V, so that the weight is F · G₂/G₁, and what several scatterings add. */
export function specularLobe(brdf: Brdf): Lobe {
  const { N, V, NV } = brdf;
  const toward = (H: Vec3): Vec3 => reflect(scale(V, -1), H);
  if (brdf.smooth) return { sample: () => toward(N), weight: () => fresnel(brdf, NV) };
  const hidden = NV + smithTerm(brdf, V, NV);
  const weight = (L: Vec3): SpectralFilter => {
    const kept = keptOf(brdf, L);
    if (kept === 0) return neutralFilter(0);
    return scaleFilter(multiple(brdf, fresnel(brdf, dot(V, normalize(add(L, V))))), kept);
  };
  const direction = (random: Random): Vec3 => toward(visibleNormal(brdf, random(), random()));
  // From below the shading normal's horizon, where N·V is clamped, the density of visible normals is not that of the formula.
  if (dot(N, V) < NV) return { sample: direction, weight };
  return {
    sample: direction,
    weight,
    pdf: (L) => ggxDistribution(brdf, normalize(add(L, V))) / (2 * hidden),
  };
}

/** The Trowbridge–Reitz (GGX) distribution of microfacet normals. */
function ggxDistribution({ N, roughness, grooves }: Brdf, H: Vec3): number {
  const cosine = Math.min(dot(N, H), 1);
  if (cosine <= 0) return 0;
  if (grooves) {
    const spread = (dot(grooves.T, H) / grooves.a) ** 2 + (dot(grooves.B, H) / grooves.b) ** 2 + cosine * cosine;
    return 1 / (Math.PI * grooves.a * grooves.b * spread * spread);
  }
  const a2 = roughness ** 4;
  const spread = cosine * cosine * (a2 - 1) + 1;
  return a2 / (spread * spread * Math.PI);
}

/** A microfacet normal visible from V, by two numbers 0 … 1. */
function visibleNormal({ N, V, roughness, grooves }: Brdf, u: number, v: number): Vec3 {
  if (grooves) return stretchedNormal(N, [grooves.T, grooves.B], V, [grooves.a, grooves.b], u, v);
  return stretchedNormal(N, orthonormalBasis(N), V, [roughness ** 2, roughness ** 2], u, v);
}

export const sampleVisibleNormal = (N: Vec3, V: Vec3, a: number, random: Random): Vec3 =>
  stretchedNormal(N, orthonormalBasis(N), V, [a, a], random(), random());

/** Source: Heitz 2018, "Sampling the GGX distribution of visible normals", JCGT 7(4). */
function stretchedNormal(
  N: Vec3,
  [s, t]: readonly [Vec3, Vec3],
  V: Vec3,
  [a, b]: readonly [number, number],
  u: number,
  v: number,
): Vec3 {
  const Vh = normalize([a * dot(V, s), b * dot(V, t), Math.max(dot(V, N), 1e-3)]);
  const flat = Vh[0] ** 2 + Vh[1] ** 2;
  const T1: Vec3 = flat > 0 ? scale([-Vh[1], Vh[0], 0], 1 / Math.sqrt(flat)) : [1, 0, 0];
  const T2: Vec3 = [Vh[1] * T1[2] - Vh[2] * T1[1], Vh[2] * T1[0] - Vh[0] * T1[2], Vh[0] * T1[1] - Vh[1] * T1[0]];
  const r = Math.sqrt(u);
  const phi = 2 * Math.PI * v;
  const x = r * Math.cos(phi);
  const half = (1 + Vh[2]) / 2;
  const y = (1 - half) * Math.sqrt(1 - x * x) + half * r * Math.sin(phi);
  const z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
  const Nh = addScaled(addScaled(scale(T1, x), T2, y), Vh, z);
  return normalize(add(addScaled(scale(s, a * Nh[0]), t, b * Nh[1]), scale(N, Math.max(1e-6, Nh[2]))));
}
